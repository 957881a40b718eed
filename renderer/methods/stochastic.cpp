// Stochastic transparency: fragments cover random samples of their pixel, as many as they are opaque, and the
// depth test sorts what covers. Enderton, Sintorn, Shirley and Luebke, "Stochastic Transparency", I3D 2010,
// section 3, with all that it adds to the idea: samples are stratified; rounds of a multisampled depth buffer
// each are drawn first, then every fragment is weighted by the share of samples it is not behind
// (depth-based); total alpha is exact, and the weights are normalised to it (alpha correction). The equations
// are in shaders/methods/stochastic/.
//
// Without the correction the weights are believed as they are. The expectation of the picture is then the
// exact one, for gray transmission: the average over samples of the nearest surviving fragment's colour has
// the same, with more noise. With it the noise is less and the expectation slightly off: a ratio of two
// estimates is.
//
// Limits: noise, which falls with the square root of the number of samples. Fragments of one depth do not
// hide each other.
#include "shaders/methods/stochastic/stochastic.h"

#include "renderer/methods/methods.h"
#include "renderer/methods/parts/weighted.h"
#include "renderer/probe.h"

namespace plume {
namespace {

class Stochastic final : public Method {
 public:
  std::string_view id() const override { return "stochastic"; }
  Traits traits() const override {
    return {
        .title = "Stochastic transparency",
        .source = "Enderton, Sintorn, Shirley and Luebke, I3D 2010, section 3: depth-based, alpha-corrected",
        .transmission = "the mean of RGB",
        .emission = "in the weighted average where covered; added as far as it is seen where not",
        .limits = "noise, which falls with the square root of the number of samples",
        .street_rmse = 0.052};
  }

  void visit(ParameterVisitor& visitor) override {
    visitor.integer("passes", passes_,
                    {.min = 1,
                     .max = 16,
                     .unit = "4 samples",
                     .help = "rounds of random samples: time and memory for noise"});
    visitor.integer("seed", seed_, {.min = 0, .max = 1 << 30, .unit = "", .help = "of the random samples"});
    visitor.toggle("alpha_correction", alpha_correction_,
                   "normalise to the exact total alpha: less noise, for a small bias");
  }

  Needs needs(glm::uvec2, const Transparents&) const override {
    Needs needs{.images = {{.name = "samples",
                            .format = vk::Format::eD32Sfloat,
                            .usage = vk::ImageUsageFlagBits::eDepthStencilAttachment |
                                     vk::ImageUsageFlagBits::eSampled,
                            .samples = shared::kSamplesARound},
                           {.name = "kept",
                            .format = vk::Format::eR32G32B32A32Sfloat,
                            .usage = vk::ImageUsageFlagBits::eStorage,
                            .layers = uint32_t(passes_)}},
                .buffers = {{.name = "round", .bytes = sizeof(shared::StochasticRound), .clear = {}}}};
    weighted().add_needs(needs);
    return needs;
  }

  void record(const Picture& picture) override {
    const Resources& resources = picture.resources;
    picture.frame.pass("scatter", [&](gpu::Pass& pass) {
      for (uint32_t round = 0; round < uint32_t(passes_); ++round) {
        scatter(pass, picture, round);
        pass.barrier();
      }
    });
    picture.frame.pass("accumulate", [&](gpu::Pass& pass) {
      picture.transparents.draw(pass, {.fragment = "methods/stochastic/accumulate.frag",
                                       .targets = weighted().targets(resources),
                                       .depth_test = &picture.opaque_depth,
                                       .opaque_depth = &picture.opaque_depth,
                                       .area = picture.area(),
                                       .vertex = "methods/stochastic/grown.vert",
                                       .constants = {uint32_t(passes_), 0u},
                                       .bindings = {{"kept", &resources.image("kept")}}});
    });
    weighted().record_resolve(picture);
  }

  void probe(const Picture& picture, const Probe& probe) const override {
    probe_with(picture, probe, "methods/stochastic/probe.comp", {uint32_t(passes_)},
               {{"kept", &picture.resources.image("kept")}});
  }

  nlohmann::json statistics(gpu::Device&, const Resources&) const override {
    return {{"samples_a_pixel", uint32_t(passes_) * shared::kSamplesARound},
            {"geometry_passes", passes_ + 1}};
  }

 private:
  Weighted weighted() const { return {.normalise = alpha_correction_}; }

  void scatter(gpu::Pass& pass, const Picture& picture, uint32_t round) const {
    const Resources& resources = picture.resources;
    const gpu::Image& samples = resources.image("samples");
    pass.update(resources.buffer("round"), shared::StochasticRound{.seed = uint32_t(seed_), .round = round});
    pass.draw({.vertex = "post/fullscreen.vert",
               .fragment = "methods/stochastic/opaque.frag",
               .targets = {},
               .depth = &samples,
               .depth_use = gpu::DepthUse::kWrite,
               .area = picture.area(),
               .constants = {},
               .bindings = {{"opaque_depth", &picture.opaque_depth}}},
              0u);
    pass.barrier();
    picture.transparents.draw(pass, {.fragment = "methods/stochastic/scatter.frag",
                                     .targets = {},
                                     .depth_test = &samples,
                                     .depth_use = gpu::DepthUse::kTestAndWrite,
                                     .opaque_depth = &picture.opaque_depth,
                                     .area = picture.area(),
                                     .vertex = "methods/stochastic/grown.vert",
                                     .constants = {},
                                     .bindings = {{"Round", &resources.buffer("round")}}});
    pass.barrier();
    struct Push {
      glm::uvec2 size;
      uint32_t slot;
    };
    pass.dispatch(pass.pipelines().compute("methods/stochastic/keep.comp"),
                  {{"samples", &samples}, {"kept", &resources.image("kept")}}, Push{picture.size, round},
                  {gpu::groups(picture.size.x, 8), gpu::groups(picture.size.y, 8), 1});
  }

  int passes_ = 4, seed_ = 0;
  bool alpha_correction_ = true;
};

}  // namespace

std::unique_ptr<Method> make_stochastic() {
  return std::make_unique<Stochastic>();
}

}  // namespace plume
