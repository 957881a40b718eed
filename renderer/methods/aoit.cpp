// Adaptive transparency that merges the furthest ("AOIT"). Salvi, Montgomery and Lefohn, "Adaptive
// Transparency", HPG 2011, streams fragments into a step function of visibility with a fixed number of nodes
// and then draws them once more, each weighed by it:
//
//   V(z) = prod_{z_i < z} t_i,   image = sum_i L_i V(z_i) + background V(infinity).
//
// The paper removes the node that changes the integral of V least. Intel's later implementations (Davies and
// others, AOIT sample for pixel synchronisation, 2013) merge the two furthest, at the depth of the nearer:
// that is what is here. It makes V independent of the order of the draws: the k - 1 nearest fragments keep
// their steps, and all the rest are one step where the nearest of them lies. Intel's sample also keeps
// colours in the nodes to draw once only; merged like that they are those of multi-layer alpha blending, the
// method `mlab`.
//
// While fragments come, a node keeps its own transmittance; then nodes are sorted and multiplied up once,
// into the published form that the second pass bisects. RGB in 32 bits, not 8 bits of one channel: thin smoke
// needs more than 255 steps, and nothing is divided by a product that may be zero.
//
// Limits: behind the nearest k - 1 everything is dimmed by everything, itself included: far layers are too
// dark, and black where one of them is opaque; where a layer falls behind them its outline shows. Nothing
// renormalises.
#include "renderer/methods/methods.h"
#include "renderer/methods/parts/pixel_nodes.h"
#include "renderer/probe.h"

namespace plume {
namespace {

constexpr pixel_nodes::Kind kKind{.light = false};

class Aoit final : public Method {
 public:
  std::string_view id() const override { return "aoit"; }
  Traits traits() const override {
    return {.title = "Adaptive transparency, furthest merged",
            .source = "Salvi et al., HPG 2011; Intel's AOIT sample, 2013 (merges the furthest)",
            .transmission = "RGB",
            .emission = "weighed by the visibility at its depth; never a node",
            .limits = "behind the nearest k - 1 steps everything dims everything: far layers are too dark",
            .street_rmse = 0.105};
  }
  std::vector<std::string> missing(const gpu::Device& device) const override {
    return pixel_nodes::missing(device, lock());
  }
  void visit(ParameterVisitor& visitor) override {
    visitor.integer(
        "nodes", nodes_,
        {.min = 1,
         .max = 64,
         .unit = "steps",
         .help = "steps of the visibility function: 20 bytes a pixel and a step of two loops each"});
    visitor.choice("lock", lock_, pixel_nodes::kLocks, "how fragments of one pixel take turns");
  }

  Needs needs(glm::uvec2 size, const Transparents&) const override {
    Needs needs;
    pixel_nodes::add_needs(needs, size, uint32_t(nodes_), kKind);
    needs.images.push_back(
        {.name = "light", .format = vk::Format::eR32G32B32A32Sfloat, .usage = kTargetUsage});
    return needs;
  }

  void record(const Picture& picture) override {
    const Resources& resources = picture.resources;
    const auto draw = [&](gpu::Pass& pass, const std::string& fragment,
                          std::vector<gpu::Attachment> targets) {
      pixel_nodes::draw(
          pass, picture, uint32_t(nodes_),
          {.fragment = fragment, .targets = std::move(targets), .constants = {}, .bindings = {}});
    };
    picture.frame.pass("insert", [&](gpu::Pass& pass) {
      pixel_nodes::reset(pass, resources, kKind);
      pass.barrier();
      draw(pass, pixel_nodes::insert_shader("methods/aoit", lock()), {});
    });
    const std::array<uint32_t, 3> squares{gpu::groups(picture.size.x, 8), gpu::groups(picture.size.y, 8), 1};
    picture.frame.pass("accumulate", [&](gpu::Pass& pass) {
      pass.dispatch(pass.pipelines().compute("methods/aoit/accumulate.comp", {uint32_t(nodes_)}),
                    pixel_nodes::bindings(resources), picture.size, squares);
    });
    picture.frame.pass("blend", [&](gpu::Pass& pass) {
      draw(pass, "methods/aoit/blend.frag",
           {{.image = &resources.image("light"), .blend = gpu::Blend::kAdd, .clear = {{0, 0, 0, 0}}}});
    });
    picture.frame.pass("resolve", [&](gpu::Pass& pass) {
      gpu::Bindings bindings = pixel_nodes::bindings(resources);
      bindings.push_back({"light", &resources.image("light")});
      bindings.push_back({"opaque_color", &picture.opaque_color});
      bindings.push_back({"result", &picture.result});
      pass.dispatch(pass.pipelines().compute("methods/aoit/resolve.comp", {uint32_t(nodes_)}), bindings,
                    picture.size, squares);
    });
  }

  void probe(const Picture& picture, const Probe& probe) const override {
    probe_with(picture, probe, "methods/aoit/probe.comp", {uint32_t(nodes_)},
               pixel_nodes::bindings(picture.resources));
  }

  nlohmann::json statistics(gpu::Device& device, const Resources& resources) const override {
    const shared::NodeOverflow overflow = pixel_nodes::overflow(device, resources);
    return {{"merged_fragments", overflow.fragments}, {"pixels_with_merges", overflow.pixels}};
  }
  std::span<const Shortfall> shortfalls() const override {
    static constexpr Shortfall kShortfalls[] = {
        {.statistic = "merged_fragments",
         .what = "Fragments that found no node free and were merged, which makes what is far too dark",
         .remedy = "Raise `nodes`"}};
    return kShortfalls;
  }

 private:
  pixel_nodes::Lock lock() const { return pixel_nodes::Lock(lock_); }

  int nodes_ = 8, lock_ = 0;
};

}  // namespace

std::unique_ptr<Method> make_aoit() {
  return std::make_unique<Aoit>();
}

}  // namespace plume
