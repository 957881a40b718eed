// The exact reference: every fragment captured per pixel in a linked list (Yang et al., EGSR 2010), sorted by
// (depth, card), composited in 32-bit float. It never truncates: a pool that is too small is grown and the
// frame drawn again.
#include "renderer/methods/methods.h"
#include "renderer/methods/parts/fragment_list.h"
#include "renderer/probe.h"

namespace plume {
namespace {

class Reference final : public Method {
 public:
  std::string_view id() const override { return "reference"; }
  Traits traits() const override {
    return {.title = "Exact reference",
            .source = "per-pixel linked lists, Yang et al. 2010; sorted by (depth, card), 32-bit composite",
            .transmission = "RGB, exact",
            .emission = "exact",
            .limits = "memory grows with the number of fragments; slow",
            .exact = true};
  }

  Needs needs(glm::uvec2 size, const Transparents&) const override {
    Needs needs;
    fragment_list::add_needs(needs, size, capacity_);
    return needs;
  }

  Outputs outputs() const override { return {.distortion = true, .surface = true}; }
  Needs output_needs(glm::uvec2, const Transparents&, const Outputs& wanted) const override {
    if (!wanted.distortion && !wanted.surface) return {};
    return {.images = {},
            .buffers = {{.name = "extras", .bytes = uint64_t(capacity_) * sizeof(glm::vec2), .clear = {}}}};
  }

  void record(const Picture& picture) override {
    const Resources& resources = picture.resources;
    const bool outputs = picture.distortion || picture.surface;
    const auto capture = [&](gpu::Pass& pass, Transparents::Style style) {
      style.depth_test = style.opaque_depth = &picture.opaque_depth;
      style.area = picture.area();
      style.bindings = fragment_list::bindings(resources);
      picture.transparents.draw(pass, style);
    };

    picture.frame.pass("capture", [&](gpu::Pass& pass) {
      fragment_list::reset(pass, resources, capacity_, outputs ? &resources.buffer("extras") : nullptr);
      pass.barrier();
      capture(pass, {.fragment = "methods/reference/capture.frag",
                     .targets = {},
                     .constants = {outputs ? 1u : 0u},
                     .bindings = {}});
      if (picture.distortion)
        capture(pass, {.fragment = "methods/reference/haze.frag",
                       .targets = {},
                       .vertex = "surface/haze.vert",
                       .source = Source::kHaze,
                       .constants = {},
                       .bindings = {}});
    });
    fragment_list::record_composite(picture, picture.opaque_color, true);
    if (!outputs) return;
    const Transparents& transparents = picture.transparents;
    const uint32_t haze_first = transparents.first(Source::kHaze);
    picture.frame.pass("outputs", [&](gpu::Pass& pass) {
      pass.dispatch(pass.pipelines().compute("methods/reference/outputs.comp",
                                             {picture.distortion ? 1u : 0u, picture.surface ? 1u : 0u}),
                    {{"View", transparents.view},
                     {"Cards", transparents.cards},
                     {"Pool", &resources.buffer("pool")},
                     {"Heads", &resources.buffer("heads")},
                     {"distortion", picture.distortion ? picture.distortion : picture.surface},
                     {"surface", picture.surface ? picture.surface : picture.distortion}},
                    glm::uvec2(haze_first, haze_first + transparents.number(Source::kHaze)),
                    {gpu::groups(picture.size.x, 8), gpu::groups(picture.size.y, 8), 1});
    });
  }

  void probe(const Picture& picture, const Probe& probe) const override {
    probe_with(picture, probe, "methods/parts/fragment_list/probe.comp", {},
               fragment_list::bindings(picture.resources));
  }

  bool must_redraw(gpu::Device& device, const Resources& resources) override {
    return fragment_list::grow(device, resources, capacity_);
  }

 private:
  uint32_t capacity_ = 1u << 16;
};

}  // namespace

std::unique_ptr<Method> make_reference() {
  return std::make_unique<Reference>();
}

}  // namespace plume
