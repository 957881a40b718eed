// Moment-based order-independent transparency: two draws. The first sums moments of the absorbance over
// depth, the second weighs every fragment by the transmittance that they tell. Muenstermann, Krumpen, Klein
// and Peters, "Moment-Based Order-Independent Transparency", I3D 2018; at lower resolutions: Sharpe, "Moment
// Transparency", HPG 2018. The equations are in shaders/methods/moments/: basis.glsl, reconstruct.glsl.
//
// Limits: a few moments smooth out steps, so near-opaque surfaces bleed; every fragment moves all of them, so
// a far one changes the near ones. At lower resolutions what one texel sums is seen by its neighbours.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <iterator>

#include "renderer/methods/methods.h"
#include "renderer/methods/parts/farthest_depth.h"
#include "renderer/methods/parts/weighted.h"
#include "renderer/probe.h"
#include "shaders/methods/moments/depth_warp.h"

namespace plume {
namespace {

constexpr std::string_view kKinds[] = {"power4", "power6", "power8", "trig2", "trig3", "trig4"};
constexpr float kPublishedBias[] = {5e-7f, 5e-6f, 5e-5f, 4e-7f, 8e-7f, 1.5e-6f};
constexpr uint32_t kNodes[] = {2, 3, 4, 2, 3, 4};
constexpr std::string_view kResolutions[] = {"1/1", "1/2", "1/4", "1/8"};
constexpr std::string_view kBounds[] = {"cards", "planes"};

/// Differences of moments are small: 16 bits would leave nothing of them.
constexpr auto kOne = vk::Format::eR32Sfloat, kTwo = vk::Format::eR32G32Sfloat,
               kFour = vk::Format::eR32G32B32A32Sfloat;

constexpr const char* kLow[] = {"low_r", "low_g", "low_b"};
constexpr const char* kHigh[] = {"high_r", "high_g", "high_b"};

class Moments final : public Method {
 public:
  std::string_view id() const override { return "moments"; }
  Traits traits() const override {
    return {.title = "Moment-based",
            .source = "Muenstermann et al., I3D 2018, sections 3 and 4; lower resolutions: Sharpe, HPG 2018",
            .transmission = "RGB where something is coloured; rgb=false: the mean of RGB",
            .emission = "in the weighted average where covered; times the transmittance in front where not",
            .limits = "near-opaque surfaces bleed; far layers change near ones",
            .street_rmse = 0.039};
  }

  void visit(ParameterVisitor& visitor) override {
    visitor.choice("moments", kind_, kKinds,
                   "kept a pixel beside the total: more separate more layers, for memory and time");
    visitor.toggle("rgb", rgb_,
                   "moments for each channel: coloured glass is right, for three times the cost");
    visitor.choice("resolution", resolution_, kResolutions,
                   "of the moments, read bilinearly: coarser is cheaper and leaks at silhouettes");
    visitor.number("moment_bias", bias_,
                   {.min = 0.0,
                    .max = 0.1,
                    .unit = "",
                    .help = "mixed-in moments of a wide distribution: more is stabler and smoother; 0 = as "
                            "published for the kind"});
    visitor.number("overestimation", overestimation_,
                   {.min = 0.0,
                    .max = 1.0,
                    .unit = "",
                    .help = "share of the absorbance at a fragment's depth that dims it: 0 is the brightest "
                            "that the moments admit, 1 the darkest"});
    visitor.choice("depth_bounds", bounds_, kBounds,
                   "what depths are warped between: tight ones separate layers better, for a pass over all "
                   "cards");
  }

  std::vector<std::string> missing(const gpu::Device& device) const override {
    std::vector<std::string> lacking;
    for (const vk::Format format : {kOne, kTwo, kFour}) {
      const auto features = device.physical().getFormatProperties(format).optimalTilingFeatures;
      if (!(features & vk::FormatFeatureFlagBits::eColorAttachmentBlend))
        lacking.push_back(fmt::format("blending into {}", vk::to_string(format)));
    }
    const uint32_t targets = 1 + (rgb_ ? 3 : 1) * (nodes() > 2 ? 2 : 1);
    if (device.limits().maxColorAttachments < targets)
      lacking.push_back(fmt::format("{} colour attachments, or rgb=false", targets));
    return lacking;
  }

  Needs needs(glm::uvec2, const Transparents& transparents) const override {
    const uint32_t channels = each_channel(transparents) ? 3 : 1;
    Needs needs;
    const auto add = [&](const char* name, vk::Format format) {
      needs.images.push_back({.name = name, .format = format, .usage = kTargetUsage, .divisor = divisor()});
    };
    add("b0", channels == 3 ? kFour : kOne);
    for (uint32_t c = 0; c < channels; ++c) {
      add(kLow[c], kFour);
      if (nodes() == 3) add(kHigh[c], kTwo);
      if (nodes() == 4) add(kHigh[c], kFour);
    }
    if (divisor() > 1) farthest_depth::add_needs(needs, divisor());
    needs.buffers.push_back({.name = "bounds", .bytes = sizeof(shared::DepthBounds), .clear = 0});
    needs.buffers.push_back({.name = "warp", .bytes = sizeof(shared::DepthWarp), .clear = {}});
    weighted(transparents).add_needs(needs);
    return needs;
  }

  Outputs outputs() const override { return {.distortion = true, .surface = true}; }

  void record(const Picture& picture) override {
    record_depth_warp(picture);
    if (divisor() > 1) farthest_depth::record(picture, divisor());
    record_moments(picture);
    const Weighted sums = weighted(picture.transparents);
    picture.frame.pass("draw", [&](gpu::Pass& pass) {
      picture.transparents.draw(pass, {.fragment = "methods/moments/draw.frag",
                                       .targets = sums.targets(picture.resources),
                                       .depth_test = &picture.opaque_depth,
                                       .opaque_depth = &picture.opaque_depth,
                                       .area = picture.area(),
                                       .constants = constants(picture.transparents),
                                       .bindings = bindings(picture)});
    });
    sums.record_resolve(picture);
    record_outputs(picture);
  }

  void probe(const Picture& picture, const Probe& probe) const override {
    probe_with(picture, probe, "methods/moments/probe.comp", constants(picture.transparents),
               bindings(picture));
  }

  nlohmann::json statistics(gpu::Device& device, const Resources& resources) const override {
    double unsure = 0;
    for (const glm::vec4& sums : gpu::read<glm::vec4>(device, resources.image("emission")))
      unsure += double(sums.a);
    const auto bounds = gpu::read<shared::DepthBounds>(device, resources.buffer("bounds"))[0];
    nlohmann::json result{{"unsure_fragments", uint64_t(unsure)}};
    if (bounds.farthest != 0) {
      result["nearest_m"] = std::bit_cast<float>(~bounds.not_nearest);
      result["farthest_m"] = std::bit_cast<float>(bounds.farthest);
    }
    return result;
  }
  std::span<const Shortfall> shortfalls() const override {
    static constexpr Shortfall kShortfalls[] = {
        {.statistic = "unsure_fragments",
         .what = "Fragments that saw moments which no distribution has, by rounding, and took the nearest",
         .remedy = "Raise `moment_bias`, or keep fewer `moments`"}};
    return kShortfalls;
  }

 private:
  uint32_t nodes() const { return kNodes[kind_]; }
  uint32_t divisor() const { return 1u << uint32_t(resolution_); }
  bool each_channel(const Transparents& transparents) const {
    return rgb_ && transparents.number(Source::kRgb) > 0;
  }
  /// Weights span more than half floats hold.
  Weighted weighted(const Transparents& transparents) const {
    return {.each_channel = each_channel(transparents), .normalise = true, .full_floats = true};
  }
  gpu::Constants constants(const Transparents& transparents) const {
    const float bias = bias_ > 0.0f ? bias_ : kPublishedBias[kind_];
    return {uint32_t(kind_), each_channel(transparents) ? 1u : 0u, divisor(), std::bit_cast<uint32_t>(bias),
            std::bit_cast<uint32_t>(overestimation_)};
  }
  /// What shaders/methods/moments/transmittance.glsl reads. Images that a kind does not have are not looked
  /// at.
  gpu::Bindings bindings(const Picture& picture) const {
    const Resources& resources = picture.resources;
    const bool each = each_channel(picture.transparents);
    gpu::Bindings all{{"Warp", &resources.buffer("warp")}, {"b0", &resources.image("b0")}};
    for (uint32_t c = 0; c < 3; ++c) {
      const bool there = c == 0 || each;
      all.push_back({kLow[c], &resources.image(there ? kLow[c] : "b0")});
      all.push_back({kHigh[c], &resources.image(there && nodes() > 2 ? kHigh[c] : "b0")});
    }
    return all;
  }

  void record_depth_warp(const Picture& picture) const {
    const Transparents& transparents = picture.transparents;
    const gpu::Binding bounds{"Ends", &picture.resources.buffer("bounds")}, view{"View", transparents.view};
    gpu::Bindings of_cards = transparents.seen();
    of_cards.push_back(bounds);
    picture.frame.pass("depth_warp", [&](gpu::Pass& pass) {
      pass.dispatch(pass.pipelines().compute("methods/moments/bounds.comp"), of_cards, 0u,
                    transparents.each_seen());
      pass.barrier();
      pass.dispatch(pass.pipelines().compute("methods/moments/warp.comp", {uint32_t(bounds_)}),
                    {view, bounds, {"Warp", &picture.resources.buffer("warp")}}, 0u, {1, 1, 1});
    });
  }

  glm::uvec2 cells(const Picture& picture) const { return (picture.size + divisor() - 1u) / divisor(); }

  void record_moments(const Picture& picture) const {
    const Resources& resources = picture.resources;
    std::vector<gpu::Attachment> targets;
    const auto add = [&](const char* name) {
      targets.push_back(
          {.image = &resources.image(name), .blend = gpu::Blend::kAdd, .clear = {{0, 0, 0, 0}}});
    };
    add("b0");
    for (uint32_t c = 0; c < (each_channel(picture.transparents) ? 3u : 1u); ++c) {
      add(kLow[c]);
      if (nodes() > 2) add(kHigh[c]);
    }
    const bool full = divisor() == 1;
    const glm::uvec2 size = cells(picture);
    picture.frame.pass("moments", [&](gpu::Pass& pass) {
      picture.transparents.draw(pass,
                                {.fragment = "methods/moments/capture.frag",
                                 .targets = targets,
                                 .depth_test = full ? &picture.opaque_depth : nullptr,
                                 .opaque_depth = full ? &picture.opaque_depth : &resources.image("farthest"),
                                 .area = {size.x, size.y},
                                 .constants = constants(picture.transparents),
                                 .bindings = {{"Warp", &resources.buffer("warp")}},
                                 .covered = glm::vec2(picture.size) / glm::vec2(size * divisor())});
    });
  }

  void record_outputs(const Picture& picture) const {
    const auto draw = [&](const char* pass_name, const gpu::Image& output, Transparents::Style style) {
      style.targets = {{.image = &output, .blend = gpu::Blend::kAdd, .clear = {{0, 0, 0, 0}}}};
      style.depth_test = style.opaque_depth = &picture.opaque_depth;
      style.area = picture.area();
      style.constants = constants(picture.transparents);
      std::ranges::move(bindings(picture), std::back_inserter(style.bindings));
      picture.frame.pass(pass_name, [&](gpu::Pass& pass) { picture.transparents.draw(pass, style); });
    };
    if (picture.distortion)
      draw("distortion", *picture.distortion,
           {.fragment = "methods/moments/haze.frag",
            .targets = {},
            .vertex = "surface/haze.vert",
            .source = Source::kHaze,
            .constants = {},
            .bindings = {}});
    const bool each = each_channel(picture.transparents);
    if (picture.surface)
      draw("surface", *picture.surface,
           {.fragment = "methods/moments/surface.frag",
            .targets = {},
            .constants = {},
            .bindings = {{"through", &picture.resources.image("through")},
                         {"norm", &picture.resources.image(each ? "norm" : "accum")}}});
  }

  int kind_ = 0, resolution_ = 0, bounds_ = 0;
  bool rgb_ = true;
  float bias_ = 0.0f, overestimation_ = 0.25f;
};

}  // namespace

std::unique_ptr<Method> make_moments() {
  return std::make_unique<Moments>();
}

}  // namespace plume
