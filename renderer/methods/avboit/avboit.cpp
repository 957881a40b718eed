// AVBOIT, adaptive voxel-based order-independent transparency: extinction is splatted into a low-resolution
// volume, integrated along the rays, and read as the weight of every fragment. Drobot, "Adaptive Voxel-Based
// Order Independent Transparency", SIGGRAPH 2025 Advances in Real-Time Rendering. VBOIT is the same with
// slices that are fixed instead of following what is occupied. Each stage is a file beside this one, and each
// shader holds its stage's equation.
#include "renderer/methods/avboit/plan.h"
#include "renderer/methods/methods.h"

namespace plume {
namespace {

class Avboit final : public Method {
 public:
  explicit Avboit(bool adaptive) { settings_.adaptive = adaptive; }

  std::string_view id() const override { return settings_.adaptive ? "avboit" : "vboit"; }
  Traits traits() const override {
    return {.title = settings_.adaptive ? "Adaptive voxel-based" : "Voxel-based, fixed slices",
            .source = settings_.adaptive ? "Drobot, SIGGRAPH 2025 Advances in Real-Time Rendering, AVBOIT"
                                         : "Drobot, SIGGRAPH 2025 Advances in Real-Time Rendering, VBOIT",
            .transmission = "RGB; `colour` selects cheaper modes",
            .emission = "exact where nothing covers; else scaled as the coverage is",
            .limits =
                "events within a slice of each other mix; edges of large smoke before other edges are as "
                "coarse as a cell",
            .street_rmse = settings_.adaptive ? 0.025 : 0.03};
  }
  std::vector<std::string> missing(const gpu::Device& device) const override {
    if (device.has_int64_atomics()) return {};
    if (settings_.accumulation == avboit::Accumulation::kDeterministic)
      return {"shaderInt64 and shaderBufferInt64Atomics, or another accumulation"};
    if (settings_.exact_layer_count() == 0) return {};
    return {"shaderInt64 and shaderBufferInt64Atomics, or exact_layers=0"};
  }
  void visit(ParameterVisitor& visitor) override { settings_.visit(visitor); }

  Needs needs(glm::uvec2 size, const Transparents& transparents) const override {
    using namespace avboit;
    const Plan plan(settings_, size, transparents);
    Needs needs;
    for (const auto add : {add_depth_warp_needs, add_occupancy_needs, add_exact_layers_needs, add_splat_needs,
                           add_integrate_needs, add_zero_depth_needs, add_classify_needs,
                           add_half_particles_needs, add_accumulate_needs, add_resolve_needs})
      add(needs, plan);
    return needs;
  }

  Outputs outputs() const override { return {.distortion = true, .surface = true}; }

  const gpu::Image& prepare(const Picture& picture) override {
    using namespace avboit;
    const Plan& plan = drawn_.emplace(settings_, picture.size, picture.transparents);
    record_depth_warp(picture, plan);
    record_occupancy(picture, plan);
    record_sources(picture, plan);
    record_splat(picture, plan);
    record_exact_layers(picture, plan);
    record_integrate(picture, plan);
    record_zero_depth(picture, plan);
    record_classify(picture, plan);
    return settings_.cull_opaque ? visible_depth(picture, plan) : picture.opaque_depth;
  }

  nlohmann::json statistics(gpu::Device& device, const Resources& resources) const override {
    if (!drawn_) return nlohmann::json::object();
    return avboit::statistics(device, resources, *drawn_);
  }
  std::span<const Shortfall> shortfalls() const override {
    static constexpr Shortfall kShortfalls[] = {
        {.statistic = "virtual_slices_lacking",
         .what =
             "Virtual slices that `slice_thickness` asks for and there are not, so that slices are thicker",
         .remedy = "Ask for thicker slices, or a shorter `thickness_range`"},
        {.statistic = "slices_apart_dropped",
         .what = "Sets of slices that would keep layers apart and found no room",
         .remedy = "Raise `slices`"},
        {.statistic = "rays_overflowed",
         .what = "Rays of the volume that end in a slice too opaque for its bits",
         .remedy = "Nothing is seen behind it; where that is wrong, set `splat` to words32"},
        {.statistic = "rgb_channels_overflowed",
         .what = "Channels of RGB rays that end in a slice too opaque for its bits",
         .remedy = "Set `rgb_splat` to words32"},
        {.statistic = "rgb_rays_carried",
         .what = "RGB rays that carry from one channel into the next, which tints what lies behind",
         .remedy = "Set `rgb_splat` to words32"},
        {.statistic = "pixels_sharing_a_slice",
         .what = "Pixels whose coloured events share a slice, which are left untinted",
         .remedy = "Raise `slices`, or set `colour` to rgb"},
        {.statistic = "layers_merged",
         .what = "Fragments of sharp cards that found no exact layer free and were merged into one slab",
         .remedy = "Raise `exact_layers`"}};
    constexpr size_t kOfAdaptation = 2;
    return std::span(kShortfalls).subspan(settings_.adaptive ? 0 : kOfAdaptation);
  }

  void record(const Picture& picture) override {
    avboit::record_half_depth(picture, *drawn_);
    avboit::record_accumulate(picture, *drawn_);
    avboit::record_resolve(picture, *drawn_);
    avboit::record_outputs(picture, *drawn_);
  }

  std::vector<Inspection> inspections() const override { return avboit::inspections(settings_); }
  void inspect(const Picture& picture, const Glance& glance) const override {
    avboit::record_inspection(picture, *drawn_, glance);
  }
  std::vector<Transparents::Style> shading(const Picture& picture) const override {
    return avboit::shading(picture, *drawn_);
  }
  std::vector<DepthSlice> depth_slices(gpu::Device& device, const Resources& resources) const override {
    if (!drawn_) return {};
    return avboit::depth_slices(device, resources, *drawn_);
  }

  void probe(const Picture& picture, const Probe& probe) const override {
    avboit::record_probe(picture, *drawn_, probe);
  }

  DepthMarks depth_marks(gpu::Device& device, const Resources& resources, const Transparents& transparents,
                         glm::uvec2 pixel) const override {
    if (!drawn_) return {};
    return avboit::depth_marks(device, resources, *drawn_, transparents, pixel);
  }

 private:
  avboit::Settings settings_;
  std::optional<avboit::Plan> drawn_;  // of the last frame
};

}  // namespace

std::unique_ptr<Method> make_avboit() {
  return std::make_unique<Avboit>(true);
}

std::unique_ptr<Method> make_vboit() {
  return std::make_unique<Avboit>(false);
}

}  // namespace plume
