#include "renderer/methods/avboit/plan.h"

namespace plume::avboit {
namespace {

vk::Format sum_format(Accumulation accumulation) {
  switch (accumulation) {
    case Accumulation::kR11G11B10:
      return vk::Format::eB10G11R11UfloatPack32;
    case Accumulation::kHalf:
      return vk::Format::eR16G16B16A16Sfloat;
    case Accumulation::kFloat:
      return vk::Format::eR32G32B32A32Sfloat;
  }
  throw std::logic_error("unknown accumulation");
}

}  // namespace

void add_accumulate_needs(Needs& needs, const Plan& plan) {
  const vk::Format format = sum_format(plan.settings.accumulation);
  needs.images.push_back({.name = "light", .format = format, .usage = kTargetUsage});
  needs.images.push_back({.name = "norm", .format = format, .usage = kTargetUsage});
  needs.images.push_back({.name = "through", .format = format, .usage = kTargetUsage});
}

void record_accumulate(const Picture& picture, const Plan& plan) {
  const auto image = [&](const char* name) { return &picture.resources.image(name); };
  const auto buffer = [&](const char* name) { return &picture.resources.buffer(name); };
  constexpr std::array<float, 4> kNothing{0, 0, 0, 1}, kZero{0, 0, 0, 0}, kOne{1, 1, 1, 1};
  const Settings& s = plan.settings;

  const auto draw = [&](gpu::Pass& pass, Source source, bool first) {
    const bool rgb = source == Source::kRgb;
    const auto clear = [&](const std::array<float, 4>& color) { return first ? std::optional(color) : std::nullopt; };
    std::vector<gpu::Attachment> targets{
        {.image = image("light"), .blend = gpu::Blend::kAddMultiplyAlpha, .clear = clear(kNothing)}};
    if (s.normalise)
      targets.push_back({.image = image("norm"), .blend = gpu::Blend::kAdd, .clear = clear(kZero)});
    if (rgb) targets.push_back({.image = image("through"), .blend = gpu::Blend::kMultiply, .clear = kOne});
    picture.transparents.draw(
        pass, {.fragment = "methods/avboit/accumulate.frag",
               .targets = std::move(targets),
               .depth_test = &visible_depth(picture, plan),
               .opaque_depth = &picture.opaque_depth,
               .area = picture.area(),
               .source = source,
               .constants = {uint32_t(s.sampling), plan.rgb ? 1u : 0u, s.linear_splat ? 1u : 0u, rgb ? 1u : 0u},
               .bindings = {{"VolumeBlock", buffer("volume")},
                            {"WarpTable", buffer("warp")},
                            {"Integral", buffer("integral")},
                            {"IntegralRgb", buffer("integral_rgb")},
                            {"RgbStart", buffer("rgb_start")}},
               .count_fragments = true});
  };
  picture.frame.pass("draw", [&](gpu::Pass& pass) {
    draw(pass, Source::kScalar, true);
    draw(pass, Source::kRgb, false);
  });
  picture.frame.pass("resolve", [&](gpu::Pass& pass) {
    pass.dispatch(pass.pipelines().compute("methods/avboit/resolve.comp", {s.normalise ? 1u : 0u}),
                  {{"light", image("light")},
                   {"norm", image("norm")},
                   {"through", image("through")},
                   {"opaque_color", &picture.opaque_color},
                   {"result", &picture.result}},
                  picture.size, {gpu::groups(picture.size.x, 8), gpu::groups(picture.size.y, 8), 1});
  });
}

}  // namespace plume::avboit
