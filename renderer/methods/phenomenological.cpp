// Phenomenological transparency. McGuire and Mara, "A Phenomenological Scattering Model for Order-Independent
// Transparency", I3D 2016, and "Phenomenological Transparency", TVCG 23(5), 2017: one pass sums a weighted
// average as weighted blending does, multiplies a coloured modulation of the background as "Fast Colored
// Transparency" did, and adds up how far the background is bent and how much it is blurred, as a variance.
// The composite looks the background up accordingly. The equations are in
// shaders/methods/phenomenological/draw.frag and composite.comp.
//
// Where the sources leave something open: scattering is given as an angle, which stands for their 1 -
// collimation; it counts by the coverage itself, not by the coverage that transmission has reduced, since
// clear ground glass would not blur. Their refraction takes a surface's normal and refractive index at a
// background four metres behind; cards have neither, so what refracts is haze, by the slope of its puffs and
// the true depth behind it. The variance has a 16-bit target instead of the modulation's 8-bit alpha.
//
// Limits: only opaque things are seen blurred or bent; the weights guess from depth; a layer behind coloured
// glass is tinted by no more than half of its hue.
#include <bit>

#include "renderer/methods/methods.h"
#include "renderer/methods/parts/window_weight.h"
#include "renderer/probe.h"

namespace plume {
namespace {

constexpr std::string_view kSums[] = {"half", "float"};
constexpr std::string_view kModulations[] = {"unorm8", "half", "float"};

class Phenomenological final : public Method {
 public:
  std::string_view id() const override { return "phenomenological"; }
  Traits traits() const override {
    return {.title = "Phenomenological",
            .source = "McGuire and Mara, I3D 2016 and TVCG 23(5) 2017",
            .transmission = "RGB for the background; half of its hue for what is drawn",
            .emission = "in the weighted average where covered; added unattenuated where not",
            .limits = "blurs and bends the opaque background only; weights guess from depth",
            .street_rmse = 0.23,
            .moves_background = true};
  }

  void visit(ParameterVisitor& visitor) override {
    weight_.visit(visitor);
    visitor.toggle("self_modulation", self_modulation_,
                   "tints what is drawn by half of the modulation's hue, as if seen through itself");
    visitor.toggle("refraction", refraction_, "haze bends the background, at a draw more");
    visitor.number("diffusion_reach_m", reach_,
                   {.min = 0.0,
                    .max = 100.0,
                    .unit = "m",
                    .help = "how far behind a diffuser a distant background is taken to be: more blurs more, "
                            "0 blurs nothing"});
    visitor.number("diffusion_focus_m", focus_,
                   {.min = 0.001,
                    .max = 100.0,
                    .unit = "m",
                    .help = "distance from a diffuser at which half of the blur is reached: more keeps what "
                            "is close to it sharper"});
    visitor.integer("blur_radius", blur_radius_,
                    {.min = 1,
                     .max = 128,
                     .unit = "pixels",
                     .help = "where blurs end: more than 8 are sampled sparsely, so cost is bounded"});
    visitor.choice("sums", sums_, kSums, "floats of the weighted sums");
    visitor.choice("modulation", modulation_, kModulations,
                   "of what the background is multiplied by: the papers have 8 bits, too coarse for smoke");
  }

  Needs needs(glm::uvec2, const Transparents&) const override {
    const vk::Format sums = sums_ == 1 ? vk::Format::eR32G32B32A32Sfloat : vk::Format::eR16G16B16A16Sfloat;
    constexpr vk::Format kFormats[] = {vk::Format::eR8G8B8A8Unorm, vk::Format::eR16G16B16A16Sfloat,
                                       vk::Format::eR32G32B32A32Sfloat};
    return {.images = {{.name = "accum", .format = sums, .usage = kTargetUsage},
                       {.name = "modulation", .format = kFormats[modulation_], .usage = kTargetUsage},
                       {.name = "emission", .format = sums, .usage = kTargetUsage},
                       {.name = "bent", .format = vk::Format::eR16G16B16A16Sfloat, .usage = kTargetUsage}},
            .buffers = {{.name = "counts", .bytes = 8, .clear = 0}}};
  }
  Outputs outputs() const override { return {.surface = true}; }

  void record(const Picture& picture) override {
    const auto image = [&](const char* name) { return &picture.resources.image(name); };
    constexpr std::array<float, 4> kZero{0, 0, 0, 0}, kOne{1, 1, 1, 1};
    const auto draw = [&](gpu::Pass& pass, Transparents::Style style) {
      style.depth_test = style.opaque_depth = &picture.opaque_depth;
      style.area = picture.area();
      picture.transparents.draw(pass, style);
    };
    picture.frame.pass("draw", [&](gpu::Pass& pass) {
      draw(pass, {.fragment = "methods/phenomenological/draw.frag",
                  .targets = {{.image = image("accum"), .blend = gpu::Blend::kAdd, .clear = kZero},
                              {.image = image("modulation"), .blend = gpu::Blend::kMultiply, .clear = kOne},
                              {.image = image("emission"), .blend = gpu::Blend::kAdd, .clear = kZero},
                              {.image = image("bent"), .blend = gpu::Blend::kAdd, .clear = kZero}},
                  .constants = constants(),
                  .bindings = {},
                  .count_fragments = true});
    });
    if (refraction_ && picture.transparents.number(Source::kHaze) > 0)
      picture.frame.pass("refract", [&](gpu::Pass& pass) {
        draw(pass, {.fragment = "methods/phenomenological/haze.frag",
                    .targets = {{.image = image("bent"), .blend = gpu::Blend::kAdd, .clear = {}}},
                    .vertex = "surface/haze.vert",
                    .source = Source::kHaze,
                    .constants = {},
                    .bindings = {}});
      });
    picture.frame.pass("composite", [&](gpu::Pass& pass) {
      pass.dispatch(
          pass.pipelines().compute("methods/phenomenological/composite.comp",
                                   {self_modulation_ ? 1u : 0u, uint32_t(blur_radius_), uint32_t(sums_)}),
          {{"View", picture.transparents.view},
           {"accum", image("accum")},
           {"modulation", image("modulation")},
           {"emission", image("emission")},
           {"bent", image("bent")},
           {"opaque_color", &picture.opaque_color},
           {"opaque_depth", &picture.opaque_depth},
           {"result", &picture.result},
           {"Counts", &picture.resources.buffer("counts")}},
          picture.size, {gpu::groups(picture.size.x, 8), gpu::groups(picture.size.y, 8), 1});
    });
    if (!picture.surface) return;
    picture.frame.pass("surface", [&](gpu::Pass& pass) {
      draw(pass, {.fragment = "methods/phenomenological/surface.frag",
                  .targets = {{.image = picture.surface, .blend = gpu::Blend::kAdd, .clear = kZero}},
                  .constants = constants(),
                  .bindings = {{"accum", image("accum")}, {"modulation", image("modulation")}}});
    });
  }

  void probe(const Picture& picture, const Probe& probe) const override {
    const Resources& resources = picture.resources;
    gpu::Constants all = constants();
    all.push_back(self_modulation_ ? 1u : 0u);
    probe_with(picture, probe, "methods/phenomenological/probe.comp", all,
               {{"accum", &resources.image("accum")}, {"modulation", &resources.image("modulation")}});
  }

  nlohmann::json statistics(gpu::Device& device, const Resources& resources) const override {
    const auto counts = gpu::read<uint32_t>(device, resources.buffer("counts"));
    return {{"overflowed_pixels", counts[0]}, {"clipped_blur_pixels", counts[1]}};
  }
  std::span<const Shortfall> shortfalls() const override {
    static constexpr Shortfall kShortfalls[] = {
        {.statistic = "overflowed_pixels",
         .what = "Pixels whose sums are too large for their floats, so that they have lost their colour",
         .remedy = "Set `sums` to float"},
        {.statistic = "clipped_blur_pixels",
         .what = "Pixels that are blurred less than their diffuser asks for",
         .remedy = "Raise `blur_radius`"}};
    return kShortfalls;
  }

 private:
  gpu::Constants constants() const {
    gpu::Constants all = weight_.constants();
    all.insert(all.end(), {std::bit_cast<uint32_t>(reach_), std::bit_cast<uint32_t>(focus_)});
    return all;
  }

  WindowWeight weight_;
  bool self_modulation_ = true, refraction_ = true;
  float reach_ = 2.5f, focus_ = 0.1f;
  int blur_radius_ = 32, sums_ = 0, modulation_ = 1;
};

}  // namespace

std::unique_ptr<Method> make_phenomenological() {
  return std::make_unique<Phenomenological>();
}

}  // namespace plume
