// Weighted, blended order-independent transparency. McGuire and Bavoil, JCGT 2(2), 2013; see
// shaders/methods/wboit.frag.
#include <bit>

#include "renderer/methods/methods.h"

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
        .limits = "the weight must be tuned to the scene's depths; near-opaque surfaces bleed"};
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
    return {
        .images = {{.name = "accum", .format = vk::Format::eR16G16B16A16Sfloat, .usage = kTargetUsage},
                   {.name = "revealage", .format = vk::Format::eR16Sfloat, .usage = kTargetUsage},
                   {.name = "emission", .format = vk::Format::eR16G16B16A16Sfloat, .usage = kTargetUsage}},
        .buffers = {}};
  }

  void record(const Picture& picture) override {
    const auto image = [&](const char* name) { return &picture.resources.image(name); };
    constexpr std::array<float, 4> kZero{0, 0, 0, 0}, kOne{1, 1, 1, 1};

    picture.frame.pass("draw", [&](gpu::Pass& pass) {
      picture.transparents.draw(
          pass, {.fragment = "methods/wboit.frag",
                 .targets = {{.image = image("accum"), .blend = gpu::Blend::kAdd, .clear = kZero},
                             {.image = image("revealage"), .blend = gpu::Blend::kMultiply, .clear = kOne},
                             {.image = image("emission"), .blend = gpu::Blend::kAdd, .clear = kZero}},
                 .depth_test = &picture.opaque_depth,
                 .opaque_depth = &picture.opaque_depth,
                 .area = picture.area(),
                 .constants = {uint32_t(weight_), std::bit_cast<uint32_t>(depth_scale_)},
                 .bindings = {}});
    });
    picture.frame.pass("resolve", [&](gpu::Pass& pass) {
      pass.dispatch(pass.pipelines().compute("methods/wboit_resolve.comp"),
                    {{"accum", image("accum")},
                     {"revealage", image("revealage")},
                     {"emission", image("emission")},
                     {"opaque_color", &picture.opaque_color},
                     {"result", &picture.result}},
                    picture.size, {gpu::groups(picture.size.x, 8), gpu::groups(picture.size.y, 8), 1});
    });
  }

 private:
  int weight_ = 0;
  float depth_scale_ = 1.0f;
};

}  // namespace

std::unique_ptr<Method> make_wboit() {
  return std::make_unique<Wboit>();
}

}  // namespace plume
