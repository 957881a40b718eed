// Weighted, blended order-independent transparency. McGuire and Bavoil, JCGT 2(2), 2013; see
// shaders/methods/wboit/draw.frag.
#include <bit>

#include "renderer/methods/methods.h"
#include "renderer/methods/weighted.h"
#include "renderer/probe.h"

namespace plume {
namespace {

constexpr std::string_view kWeights[] = {"eq7", "eq8", "eq9", "eq10", "colour_aware", "learnopengl"};

class Wboit final : public Method {
 public:
  std::string_view id() const override { return "wboit"; }
  Traits traits() const override {
    return {
        .title = "Weighted blended",
        .source =
            "McGuire and Bavoil, JCGT 2(2) 2013, equations 7 to 10; McGuire's blog 2013; LearnOpenGL 2020",
        .transmission = "the mean of RGB",
        .emission = "in the weighted average where covered; added unattenuated where not",
        .limits = "the weight must be tuned to the scene's depths; near-opaque surfaces bleed",
        .street_rmse = 0.25};
  }

  void visit(ParameterVisitor& visitor) override {
    visitor.choice("weight", weight_, kWeights,
                   "which published guess of the transmittance weighs a fragment");
    visitor.number("depth_scale", depth_scale_,
                   {.min = 0.001,
                    .max = 1000.0,
                    .unit = "1/m",
                    .help = "the paper's depth units per metre: tunes the weight to the scene"});
  }

  Needs needs(glm::uvec2, const Transparents&) const override {
    Needs needs;
    Weighted{}.add_needs(needs);
    return needs;
  }

  void record(const Picture& picture) override {
    picture.frame.pass("draw", [&](gpu::Pass& pass) {
      picture.transparents.draw(pass, {.fragment = "methods/wboit/draw.frag",
                                       .targets = Weighted{}.targets(picture.resources),
                                       .depth_test = &picture.opaque_depth,
                                       .opaque_depth = &picture.opaque_depth,
                                       .area = picture.area(),
                                       .constants = constants(),
                                       .bindings = {}});
    });
    Weighted{}.record_resolve(picture);
  }

  void probe(const Picture& picture, const Probe& probe) const override {
    const Resources& resources = picture.resources;
    probe_with(picture, probe, "methods/wboit/probe.comp", constants(),
               {{"accum", &resources.image("accum")}, {"through", &resources.image("through")}});
  }

 private:
  gpu::Constants constants() const { return {uint32_t(weight_), std::bit_cast<uint32_t>(depth_scale_)}; }

  int weight_ = 0;
  float depth_scale_ = 1.0f;
};

}  // namespace

std::unique_ptr<Method> make_wboit() {
  return std::make_unique<Wboit>();
}

}  // namespace plume
