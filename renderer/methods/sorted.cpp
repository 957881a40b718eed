// Alpha blending in sorted order ("No OIT"): the GPU sorts all cards by the depth of their centres, then they
// are blended back to front. The sort is part of the cost and its own pass.
#include "renderer/methods/methods.h"
#include "renderer/probe.h"
#include "renderer/radix_sort.h"

namespace plume {
namespace {

class Sorted final : public Method {
 public:
  std::string_view id() const override { return "sorted"; }
  Traits traits() const override {
    return {.title = "Sorted alpha blending",
            .source = "the baseline of Drobot 2025 (\"No OIT\"), GPU sort across all cards",
            .transmission = "RGB, by dual-source blending",
            .emission = "exact",
            .limits =
                "interpenetrating cards are ordered by their centres; 16-bit blending rounds at every layer",
            .street_rmse = 0.002};
  }

  Needs needs(glm::uvec2, const Transparents& transparents) const override {
    const uint32_t cards = transparents.count;
    const uint64_t count = std::max(cards, 1u);
    return {.images = {},
            .buffers = {{.name = "pairs", .bytes = count * 8, .clear = {}},
                        {.name = "scratch", .bytes = count * 8, .clear = {}},
                        {.name = "counts", .bytes = radix_counts_bytes(cards), .clear = {}},
                        {.name = "order", .bytes = count * 4, .clear = {}}}};
  }

  Outputs outputs() const override { return {.distortion = true, .surface = true}; }

  void record(const Picture& picture) override {
    const auto buffer = [&](const char* name) { return &picture.resources.buffer(name); };
    const Transparents& transparents = picture.transparents;
    const uint32_t count = transparents.count;

    picture.frame.pass("sort", [&](gpu::Pass& pass) {
      if (count == 0) return;
      pass.dispatch(pass.pipelines().compute("methods/sorted/keys.comp"),
                    {{"View", transparents.view}, {"Cards", transparents.cards}, {"Pairs", buffer("pairs")}},
                    count, {gpu::groups(count, 256), 1, 1});
      pass.barrier();
      radix_sort(pass, *buffer("pairs"), *buffer("scratch"), *buffer("counts"), count);
      pass.dispatch(pass.pipelines().compute("methods/sorted/order.comp"),
                    {{"Pairs", buffer("pairs")}, {"Order", buffer("order")}}, count,
                    {gpu::groups(count, 256), 1, 1});
    });
    const auto draw = [&](const char* pass_name, const gpu::Image& target, Transparents::Style style) {
      style.targets = {{.image = &target, .blend = gpu::Blend::kOverDual, .clear = {}}};
      style.depth_test = style.opaque_depth = &picture.opaque_depth;
      style.area = picture.area();
      style.order = buffer("order");
      style.backwards = true;
      picture.frame.pass(pass_name, [&](gpu::Pass& pass) {
        if (&target != &picture.result) pass.clear(target, {0, 0, 0, 0});
        pass.barrier();
        transparents.draw(pass, style);
      });
    };
    picture.frame.pass("copy", [&](gpu::Pass& pass) { pass.copy(picture.opaque_color, picture.result); });
    draw("draw", picture.result,
         {.fragment = "methods/sorted/draw.frag",
          .targets = {},
          .constants = {},
          .bindings = {},
          .count_fragments = true});
    if (picture.distortion)
      draw("distortion", *picture.distortion,
           {.fragment = "methods/sorted/distortion.frag",
            .targets = {},
            .vertex = "surface/haze.vert",
            .constants = {},
            .bindings = {}});
    if (picture.surface)
      draw("surface", *picture.surface,
           {.fragment = "methods/sorted/surface.frag", .targets = {}, .constants = {}, .bindings = {}});
  }

  void probe(const Picture& picture, const Probe& probe) const override {
    probe_by_drawing(picture, probe, InFront::kByCenter);
  }
};

}  // namespace

std::unique_ptr<Method> make_sorted() {
  return std::make_unique<Sorted>();
}

}  // namespace plume
