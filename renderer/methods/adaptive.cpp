// Adaptive transparency. Salvi, Montgomery and Lefohn, High Performance Graphics 2011: visibility along a
// pixel's ray is a step function of a fixed number of nodes, compressed as fragments are inserted by removing
// the node that changes its integral least; then every fragment is seen through it,
//   image = sum_i L_i V(z_i) + background V(infinity).
// As in their implementation for the graphics hardware of then, fragments are captured in per-pixel lists
// first, and a second pass builds V from the list and walks it again. Nothing divides by a transmittance, so
// opaque fragments need no guard. See shaders/methods/adaptive/visibility.glsl.
//
// Which way a removed step moves, and that the first and the last node stay, is as in the authors' published
// sample. Fragments are inserted as they arrive there, and the result depends on it. Here a list is inserted
// in the order of its cards, so that the order of draws changes no bit; sorted by depth first, the
// compression would look better than it is. Fragments of equal depth are ordered by card, so that one hides
// the other. The paper's visibility is one function: `rgb` keeps one a channel, with shared depths and the
// mean of their errors. What blocks nothing takes no node.
//
// Limits: a removed step moves towards the camera, over what lies between: with few nodes and many
// near-opaque layers, fragments hide themselves.
#include "renderer/methods/methods.h"
#include "renderer/methods/parts/fragment_list.h"
#include "renderer/probe.h"

namespace plume {
namespace {

class Adaptive final : public Method {
 public:
  std::string_view id() const override { return "adaptive"; }
  Traits traits() const override {
    return {.title = "Adaptive transparency",
            .source = "Salvi, Montgomery and Lefohn, High Performance Graphics 2011",
            .transmission = rgb_ ? "RGB" : "the mean of RGB",
            .emission = "seen through the visibility in front of it, as all light",
            .limits =
                "with few nodes, near-opaque layers hide themselves: a removed step of visibility moves "
                "towards the camera; memory grows with the number of fragments",
            .street_rmse = 0.035};
  }

  void visit(ParameterVisitor& visitor) override {
    visitor.integer("nodes", nodes_,
                    {.min = 2,
                     .max = 32,
                     .unit = "a pixel",
                     .help = "steps of the visibility function: more are nearer to exact, and slower"});
    visitor.toggle("rgb", rgb_, "a transmittance for each channel; off, as published, one for all");
  }

  Needs needs(glm::uvec2 size, const Transparents&) const override {
    Needs needs;
    fragment_list::add_needs(needs, size, capacity_);
    return needs;
  }

  void record(const Picture& picture) override {
    const Resources& resources = picture.resources;
    picture.frame.pass("capture", [&](gpu::Pass& pass) {
      fragment_list::reset(pass, resources, capacity_);
      pass.barrier();
      picture.transparents.draw(pass, {.fragment = "methods/reference/capture.frag",
                                       .targets = {},
                                       .depth_test = &picture.opaque_depth,
                                       .opaque_depth = &picture.opaque_depth,
                                       .area = picture.area(),
                                       .constants = {0u},
                                       .bindings = fragment_list::bindings(resources)});
    });
    picture.frame.pass("resolve", [&](gpu::Pass& pass) {
      gpu::Bindings bound = fragment_list::bindings(resources);
      bound.push_back({"opaque_color", &picture.opaque_color});
      bound.push_back({"result", &picture.result});
      pass.dispatch(pass.pipelines().compute("methods/adaptive/resolve.comp", constants()), bound,
                    picture.size, {gpu::groups(picture.size.x, 8), gpu::groups(picture.size.y, 8), 1});
    });
  }

  void probe(const Picture& picture, const Probe& probe) const override {
    probe_with(picture, probe, "methods/adaptive/probe.comp", constants(),
               fragment_list::bindings(picture.resources));
  }

  nlohmann::json statistics(gpu::Device& device, const Resources& resources) const override {
    return {{"fragments", fragment_list::pool(device, resources).count}};
  }

  bool must_redraw(gpu::Device& device, const Resources& resources) override {
    return fragment_list::grow(device, resources, capacity_);
  }

 private:
  gpu::Constants constants() const { return {uint32_t(nodes_), rgb_ ? 1u : 0u}; }

  uint32_t capacity_ = 1u << 16;
  int nodes_ = 8;
  bool rgb_ = true;
};

}  // namespace

std::unique_ptr<Method> make_adaptive() {
  return std::make_unique<Adaptive>();
}

}  // namespace plume
