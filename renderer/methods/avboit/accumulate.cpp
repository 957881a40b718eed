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
  needs.images.push_back({.name = "glow", .format = format, .usage = kTargetUsage});
  needs.images.push_back({.name = "norm", .format = vk::Format::eR16Sfloat, .usage = kTargetUsage});
  needs.images.push_back({.name = "norm_rgb",
                          .format = format,
                          .usage = kTargetUsage,
                          .divisor = plan.coloured ? 1u : 1u << 16});
  needs.images.push_back({.name = "through", .format = format, .usage = kTargetUsage});
}

void record_accumulate(const Picture& picture, const Plan& plan) {
  const auto image = [&](const char* name) { return &picture.resources.image(name); };
  const auto buffer = [&](const char* name) { return &picture.resources.buffer(name); };
  const Settings& s = plan.settings;
  const Colour colour = plan.coloured ? s.colour : Colour::kMono;

  const auto draw = [&](gpu::Pass& pass, uint32_t card_class) {
    const uint32_t kind = card_class / 4;
    const bool exact = kind == shared::kKindExact, behind_rgb = card_class & shared::kBehindRgb,
               behind_layers = card_class & shared::kBehindLayers;
    const bool tints = exact || kind == shared::kKindRgb;
    const bool each_channel =
        colour == Colour::kRgb && (kind == shared::kKindRgb || exact || behind_rgb || behind_layers);
    const uint32_t lane_bits =
        kind == shared::kKindRgb && plan.rgb ? (plan.rgb_words() == 1 ? 8u : 32u) : s.lane_bits();
    // What a kind of card does not need comes last, and is left out.
    std::vector<gpu::Attachment> targets;
    const auto add = [&](const char* name, gpu::Blend blend) {
      targets.push_back({.image = image(name), .blend = blend, .clear = {}});
    };
    add("light", gpu::Blend::kAddMultiplyAlpha);
    add(each_channel ? "norm_rgb" : "norm", gpu::Blend::kAdd);
    if (tints) add("through", gpu::Blend::kMultiply);
    if (exact) add("glow", gpu::Blend::kAdd);
    picture.transparents.draw(
        pass, {.fragment = "methods/avboit/accumulate.frag",
               .targets = std::move(targets),
               .depth_test = &visible_depth(picture, plan),
               .opaque_depth = &picture.opaque_depth,
               .area = picture.area(),
               .vertex = "methods/avboit/card_at_slice.vert",
               .constants = {uint32_t(s.sampling), s.linear_splat ? 1u : 0u, behind_rgb ? 1u : 0u,
                             tints ? 1u : 0u, kind == shared::kKindPlain ? 0u : 1u, uint32_t(colour),
                             behind_layers ? 1u : 0u, exact ? 1u : 0u, lane_bits},
               .bindings = {{"VolumeBlock", buffer("volume")},
                            {"WarpTable", buffer("warp")},
                            {"Layers", buffer("layers")},
                            {"LayerTail", buffer("layer_tail")},
                            {"integral", image("integral")},
                            {"integral_rg", image("integral_rg")},
                            {"integral_b", image("integral_b")}},
               .order = buffer("class_order"),
               .indirect = buffer("class_draws"),
               .indirect_index = card_class,
               .count_fragments = true});
  };
  picture.frame.pass("draw", [&](gpu::Pass& pass) {
    pass.clear(*image("light"), {0, 0, 0, 1});
    pass.clear(*image("glow"), {0, 0, 0, 0});
    pass.clear(*image("norm"), {0, 0, 0, 0});
    pass.clear(*image("norm_rgb"), {0, 0, 0, 0});
    pass.clear(*image("through"), {1, 1, 1, 1});
    pass.barrier();
    for (uint32_t c = 0; c < shared::kClasses; ++c) {
      const uint32_t kind = c / 4;
      const bool behind_rgb = c & shared::kBehindRgb, behind_layers = c & shared::kBehindLayers;
      if (kind == shared::kKindRgb && !plan.coloured) continue;
      if (kind == shared::kKindExact && !behind_layers) continue;
      if (behind_rgb && !plan.rgb) continue;
      if (behind_layers && plan.volume.exact_layers == 0 && kind != shared::kKindExact) continue;
      draw(pass, c);
    }
  });
  picture.frame.pass("resolve", [&](gpu::Pass& pass) {
    pass.dispatch(
        pass.pipelines().compute("methods/avboit/resolve.comp", {s.normalise ? 1u : 0u, uint32_t(colour)}),
        {{"light", image("light")},
         {"norm", image("norm")},
         {"norm_rgb", image("norm_rgb")},
         {"through", image("through")},
         {"glow", image("glow")},
         {"opaque_color", &picture.opaque_color},
         {"result", &picture.result}},
        picture.size, {gpu::groups(picture.size.x, 8), gpu::groups(picture.size.y, 8), 1});
  });
}

}  // namespace plume::avboit
