// AVBOIT in its basic form, voxel-based order-independent transparency with fixed slices and one
// transmittance for all colours. Drobot, "Adaptive Voxel-Based Order Independent Transparency", SIGGRAPH 2025
// Advances in Real-Time Rendering. clear -> farthest opaque depth of each cell -> splat -> integrate -> draw
// -> resolve; each shader holds its stage's equation.
#include "renderer/methods/methods.h"
#include "shaders/methods/avboit/volume.h"

namespace plume {
namespace {

constexpr uint32_t kDivisor = 8;
constexpr std::string_view kSliceCounts[] = {"32", "64", "128",
                                             "252"};  // n + 1 texels fit the 256 that every device has
constexpr uint32_t kSlices[] = {32, 64, 128, 252};

constexpr auto kComputedUsage = vk::ImageUsageFlagBits::eStorage | vk::ImageUsageFlagBits::eSampled;

class Avboit final : public Method {
 public:
  std::string_view id() const override { return "avboit"; }
  Traits traits() const override {
    return {.title = "Adaptive voxel-based",
            .source = "Drobot, SIGGRAPH 2025 Advances in Real-Time Rendering (basic form: fixed slices)",
            .transmission = "the mean of RGB",
            .emission = "in the weighted average where covered; added with weight T(z) where not",
            .limits = "events within `bias` slices of each other mix; silhouettes are as coarse as a cell"};
  }

  void visit(ParameterVisitor& visitor) override {
    visitor.choice("slices", slices_, kSliceCounts,
                   "more separate closer layers, for memory and integration time");
    visitor.number("curve_a", curve_a_,
                   {.min = 0.01,
                    .max = 10000.0,
                    .unit = "m",
                    .help = "depth up to which slices are about equally thick"});
    visitor.number("curve_b", curve_b_,
                   {.min = 1.0,
                    .max = 100000.0,
                    .unit = "m",
                    .help = "depth of the last slice; nearer makes all slices thinner"});
    visitor.number(
        "bias", bias_,
        {.min = 0.0,
         .max = 8.0,
         .unit = "slices",
         .help = "how far in front of itself a fragment reads the integral: less self-occludes, more "
                 "misses what is close in front"});
  }

  Needs needs(glm::uvec2 size, uint32_t) const override {
    const shared::Volume volume = volume_for(size);
    const uint64_t rays = uint64_t(volume.cells.x) * volume.cells.y;
    return {
        .images = {{.name = "farthest",
                    .format = vk::Format::eR32Sfloat,
                    .usage = kComputedUsage,
                    .divisor = kDivisor},
                   {.name = "integral",
                    .format = vk::Format::eR8Unorm,
                    .usage = kComputedUsage,
                    .divisor = kDivisor,
                    .depth = volume.slices + 1},
                   {.name = "accum", .format = vk::Format::eR16G16B16A16Sfloat, .usage = kTargetUsage},
                   {.name = "optical_depth", .format = vk::Format::eR32Sfloat, .usage = kTargetUsage},
                   {.name = "emission", .format = vk::Format::eR16G16B16A16Sfloat, .usage = kTargetUsage}},
        .buffers = {{.name = "volume", .bytes = sizeof(shared::Volume), .clear = {}},
                    {.name = "extinction", .bytes = rays * volume.slices, .clear = 0},
                    {.name = "overflow", .bytes = rays * 4, .clear = shared::kNoOverflow}}};
  }

  void record(const Picture& picture) override {
    const auto image = [&](const char* name) { return &picture.resources.image(name); };
    const auto buffer = [&](const char* name) { return &picture.resources.buffer(name); };
    const shared::Volume volume = volume_for(picture.size);
    const std::array<uint32_t, 3> cell_groups{gpu::groups(volume.cells.x, 8), gpu::groups(volume.cells.y, 8),
                                              1};
    const gpu::Binding block{"VolumeBlock", buffer("volume")};
    constexpr std::array<float, 4> kZero{0, 0, 0, 0};

    picture.frame.pass("farthest", [&](gpu::Pass& pass) {
      pass.update(*buffer("volume"), volume);
      pass.barrier();
      pass.dispatch(pass.pipelines().compute("methods/avboit/farthest.comp"),
                    {block, {"opaque_depth", &picture.opaque_depth}, {"farthest", image("farthest")}},
                    volume.cells, cell_groups);
    });
    picture.frame.pass("splat", [&](gpu::Pass& pass) {
      picture.transparents.draw(
          pass, {.fragment = "methods/avboit/splat.frag",
                 .targets = {},
                 .opaque_depth = image("farthest"),
                 .area = {volume.cells.x, volume.cells.y},
                 .constants = {},
                 .bindings = {block, {"Extinction", buffer("extinction")}, {"Overflow", buffer("overflow")}},
                 .covered = glm::vec2(picture.size) / glm::vec2(volume.cells * kDivisor)});
    });
    picture.frame.pass("integrate", [&](gpu::Pass& pass) {
      pass.dispatch(pass.pipelines().compute("methods/avboit/integrate.comp"),
                    {block,
                     {"Extinction", buffer("extinction")},
                     {"Overflow", buffer("overflow")},
                     {"integral", image("integral")}},
                    volume.cells, cell_groups);
    });
    picture.frame.pass("draw", [&](gpu::Pass& pass) {
      picture.transparents.draw(
          pass, {.fragment = "methods/avboit/accumulate.frag",
                 .targets = {{.image = image("accum"), .blend = gpu::Blend::kAdd, .clear = kZero},
                             {.image = image("optical_depth"), .blend = gpu::Blend::kAdd, .clear = kZero},
                             {.image = image("emission"), .blend = gpu::Blend::kAdd, .clear = kZero}},
                 .depth_test = &picture.opaque_depth,
                 .opaque_depth = &picture.opaque_depth,
                 .area = picture.area(),
                 .constants = {},
                 .bindings = {block, {"integral", image("integral")}}});
    });
    picture.frame.pass("resolve", [&](gpu::Pass& pass) {
      pass.dispatch(pass.pipelines().compute("methods/avboit/resolve.comp"),
                    {{"accum", image("accum")},
                     {"optical_depth", image("optical_depth")},
                     {"emission", image("emission")},
                     {"opaque_color", &picture.opaque_color},
                     {"result", &picture.result}},
                    picture.size, {gpu::groups(picture.size.x, 8), gpu::groups(picture.size.y, 8), 1});
    });
  }

 private:
  shared::Volume volume_for(glm::uvec2 size) const {
    return {.cells = (size + kDivisor - 1u) / kDivisor,
            .divisor = kDivisor,
            .slices = kSlices[slices_],
            .curve_a = curve_a_,
            .curve_b = curve_b_,
            .bias = bias_,
            .padding = 0};
  }

  int slices_ = 2;                           // 128
  float curve_a_ = 6.5f, curve_b_ = 813.0f;  // the talk's 16384 / 2^6 and 32000 inches
  float bias_ = 2.0f;
};

}  // namespace

std::unique_ptr<Method> make_avboit() {
  return std::make_unique<Avboit>();
}

}  // namespace plume
