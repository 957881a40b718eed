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
    case Accumulation::kDeterministic:
      return vk::Format::eR32G32B32A32Sfloat;
  }
  throw std::logic_error("unknown accumulation");
}

bool keeps_float(Accumulation accumulation) {
  return accumulation == Accumulation::kFloat || accumulation == Accumulation::kDeterministic;
}

/// Of the sum of weights: it loses what is thinner than its rounding as the sum of light does.
vk::Format norm_format(Accumulation accumulation) {
  return keeps_float(accumulation) ? vk::Format::eR32Sfloat : vk::Format::eR16Sfloat;
}

/// Of transmittance: the short floats of 11:11:10 would lose it.
vk::Format through_format(Accumulation accumulation) {
  return keeps_float(accumulation) ? vk::Format::eR32G32B32A32Sfloat : kHdrFormat;
}

}  // namespace

void add_accumulate_needs(Needs& needs, const Plan& plan) {
  const vk::Format format = sum_format(plan.settings.accumulation);
  const vk::Format norm = norm_format(plan.settings.accumulation);
  const vk::Format through = through_format(plan.settings.accumulation);
  const auto add = [&](const char* name, vk::Format of, uint32_t divisor, vk::ImageUsageFlags usage) {
    needs.images.push_back({.name = name, .format = of, .usage = usage, .divisor = divisor});
  };
  const uint32_t half = plan.settings.half_particles ? 2 : kNowhere;
  const bool each_channel = plan.coloured || plan.settings.accumulation == Accumulation::kDeterministic;
  add("light", format, 1, kTargetUsage);
  add("norm", norm, 1, kTargetUsage);
  add("norm_rgb", format, each_channel ? 1 : kNowhere, kTargetUsage);
  add("through", through, 1, kTargetUsage);
  add("known_light", through, 1, kTargetUsage);
  add("known_norm", through, each_channel ? 1 : kNowhere, kTargetUsage);
  add("light_half", format, half, kTargetUsage);
  add("norm_half", norm, half, kTargetUsage);
  add("norm_rgb_half", format, each_channel ? half : kNowhere, kTargetUsage);
  add("through_half", through, half, kTargetUsage);
  add("known_light_half", through, half, kTargetUsage);
  add("known_norm_half", through, each_channel ? half : kNowhere, kTargetUsage);
  add_sums_needs(needs, plan);
}

gpu::Bindings transmittance_bindings(const Picture& picture) {
  const auto image = [&](const char* name) { return &picture.resources.image(name); };
  const auto buffer = [&](const char* name) { return &picture.resources.buffer(name); };
  return {{"VolumeBlock", buffer("volume")},  {"WarpTable", buffer("warp")},
          {"Layers", buffer("layers")},       {"LayerTails", buffer("layer_tails")},
          {"integral", image("integral")},    {"integral_rg", image("integral_rg")},
          {"integral_b", image("integral_b")}};
}

std::vector<Transparents::Style> shading(const Picture& picture, const Plan& plan) {
  const auto image = [&](const std::string& name) { return &picture.resources.image(name); };
  const auto buffer = [&](const char* name) { return &picture.resources.buffer(name); };
  const Settings& s = plan.settings;
  const Colour colour = plan.colour();

  const auto draw = [&](uint32_t card_class) -> Transparents::Style {
    const uint32_t kind = card_class / 4;
    const bool exact = kind == shared::kKindExact, behind_rgb = card_class & shared::kBehindRgb,
               behind_layers = card_class & shared::kBehindLayers;
    const bool half = s.half_particles && kind == shared::kKindPlain;
    const bool tints = exact || kind == shared::kKindRgb || s.accumulation == Accumulation::kR11G11B10;
    const bool each_channel =
        colour == Colour::kRgb && (kind == shared::kKindRgb || exact || behind_rgb || behind_layers);
    const bool knows = exact || plan.tells_doubt();
    // What a kind of card does not need comes last, and is left out.
    std::vector<gpu::Attachment> targets;
    const auto add = [&](const std::string& name, gpu::Blend blend) {
      targets.push_back({.image = image(half ? name + "_half" : name), .blend = blend, .clear = {}});
    };
    add("light", gpu::Blend::kAddMultiplyAlpha);
    add(each_channel ? "norm_rgb" : "norm", gpu::Blend::kAdd);
    if (tints) add("through", gpu::Blend::kMultiply);
    if (knows) add("known_light", gpu::Blend::kAdd);
    if (knows && each_channel) add("known_norm", gpu::Blend::kAdd);
    const uint32_t lane_bits =
        kind == shared::kKindRgb && plan.rgb ? (plan.rgb_words() == 1 ? 8u : 32u) : s.lane_bits();
    const glm::uvec2 area = half ? (plan.size + 1u) / 2u : plan.size;
    return {.fragment = tints ? "methods/avboit/accumulate.frag" : "methods/avboit/accumulate_plain.frag",
            .targets = std::move(targets),
            .depth_test = half ? image("half_visible") : &visible_depth(picture, plan),
            .opaque_depth = half ? image("half_opaque") : &picture.opaque_depth,
            .area = {area.x, area.y},
            .vertex = "methods/avboit/card_at_slice.vert",
            .constants = {uint32_t(s.sampling), s.linear_splat ? 1u : 0u, behind_rgb ? 1u : 0u,
                          s.accumulation == Accumulation::kR11G11B10 ? 2u
                          : tints                                    ? 1u
                                                                     : 0u,
                          kind == shared::kKindPlain ? 0u : 1u, uint32_t(colour), behind_layers ? 1u : 0u,
                          exact ? 1u : 0u, lane_bits, half ? 2u : 1u, each_channel ? 1u : 0u,
                          plan.tells_doubt() ? 1u : 0u},
            .bindings = transmittance_bindings(picture),
            .order = buffer("class_order"),
            .indirect = buffer("class_draws"),
            .indirect_index = card_class,
            .count_fragments = true,
            .covered = glm::vec2(plan.size) / glm::vec2(area * (half ? 2u : 1u))};
  };
  std::vector<Transparents::Style> draws;
  for (uint32_t c = 0; c < shared::kClasses; ++c) {
    const uint32_t kind = c / 4;
    const bool behind_rgb = c & shared::kBehindRgb, behind_layers = c & shared::kBehindLayers;
    if (kind == shared::kKindRgb && !plan.coloured) continue;
    if (kind == shared::kKindExact && !behind_layers) continue;
    if (behind_rgb && !plan.rgb) continue;
    if (behind_layers && plan.volume.exact_layers == 0 && kind != shared::kKindExact) continue;
    draws.push_back(draw(c));
  }
  return draws;
}

void record_accumulate(const Picture& picture, const Plan& plan) {
  if (plan.settings.accumulation == Accumulation::kDeterministic) {
    record_sums(picture, plan);
    return;
  }
  const auto image = [&](const std::string& name) { return &picture.resources.image(name); };
  picture.frame.pass("draw", [&](gpu::Pass& pass) {
    for (const char* end : {"", "_half"}) {
      pass.clear(*image(std::string("light") + end), {0, 0, 0, 1});
      pass.clear(*image(std::string("norm") + end), {0, 0, 0, 0});
      pass.clear(*image(std::string("norm_rgb") + end), {0, 0, 0, 0});
      pass.clear(*image(std::string("through") + end), {1, 1, 1, 1});
      pass.clear(*image(std::string("known_light") + end), {0, 0, 0, 0});
      pass.clear(*image(std::string("known_norm") + end), {0, 0, 0, 0});
    }
    pass.barrier();
    for (const Transparents::Style& draw : shading(picture, plan)) picture.transparents.draw(pass, draw);
  });
}

}  // namespace plume::avboit
