// Weighted blending with coloured transmission. McGuire, "Fast Colored Transparency", 2015: a third target
// multiplies the background by prod(1 - a (1 - t)) for each channel, beside the weighted average and its
// revealage, whose coverage is reduced to a (1 - mean t) only after the modulation is written. See
// shaders/methods/coloured/draw.frag.
//
// The post binds the framebuffer itself as that target. Here it is a target of its own, cleared to one, with
// which the composite multiplies: the opaque image is still wanted as it was.
//
// Limits: only the background is tinted; a layer behind glass keeps its colour, and normalising one average
// of all channels dims coloured highlights. The weight is a guess, as in wboit.cpp.
#include "renderer/methods/methods.h"
#include "renderer/methods/parts/weighted.h"
#include "renderer/methods/parts/window_weight.h"
#include "renderer/probe.h"

namespace plume {
namespace {

constexpr std::string_view kSums[] = {"half", "float"};
constexpr std::string_view kRevealages[] = {"unorm8", "half", "float"};

class Coloured final : public Method {
 public:
  std::string_view id() const override { return "coloured"; }
  Traits traits() const override {
    return {.title = "Coloured weighted blended",
            .source = "McGuire, \"Fast Colored Transparency\", blog post of 27 March 2015",
            .transmission = "RGB for the background; the mean of RGB between layers",
            .emission = "in the weighted average where covered; added unattenuated where not",
            .limits = "glass tints the background, not the layers behind it; weights guess from depth",
            .street_rmse = 0.25};
  }

  void visit(ParameterVisitor& visitor) override {
    weight_.visit(visitor);
    visitor.choice("sums", sums_, kSums, "floats of the weighted sums and of the modulation");
    visitor.choice("revealage", revealage_, kRevealages,
                   "of what the weighted average leaves free: the post has 8 bits, too coarse for smoke");
  }

  Needs needs(glm::uvec2, const Transparents&) const override {
    Needs needs;
    weighted().add_needs(needs);
    return needs;
  }
  Outputs outputs() const override { return {.distortion = true, .surface = true}; }

  void record(const Picture& picture) override {
    const Weighted blend = weighted();
    picture.frame.pass("draw", [&](gpu::Pass& pass) {
      picture.transparents.draw(pass, {.fragment = "methods/coloured/draw.frag",
                                       .targets = blend.targets(picture.resources),
                                       .depth_test = &picture.opaque_depth,
                                       .opaque_depth = &picture.opaque_depth,
                                       .area = picture.area(),
                                       .constants = weight_.constants(),
                                       .bindings = {},
                                       .count_fragments = true});
    });
    blend.record_resolve(picture);
    blend.record_outputs(picture, "methods/coloured", weight_.constants());
  }

  void probe(const Picture& picture, const Probe& probe) const override {
    probe_with(picture, probe, "methods/coloured/probe.comp", weight_.constants(), weighted().sums(picture));
  }

  nlohmann::json statistics(gpu::Device& device, const Resources& resources) const override {
    return weighted().statistics(device, resources);
  }
  std::span<const Shortfall> shortfalls() const override {
    static constexpr Shortfall kShortfalls[] = {
        {.statistic = "overflowed_pixels",
         .what = "Pixels whose sums are too large for their floats, so that they have lost their colour",
         .remedy = "Set `sums` to float"}};
    return kShortfalls;
  }

 private:
  Weighted weighted() const {
    return {.full_floats = sums_ == 1,
            .revealage = Weighted::Revealage(int(Weighted::Revealage::kUnorm8) + revealage_),
            .modulates = true};
  }

  WindowWeight weight_;
  int sums_ = 0, revealage_ = 1;
};

}  // namespace

std::unique_ptr<Method> make_coloured() {
  return std::make_unique<Coloured>();
}

}  // namespace plume
