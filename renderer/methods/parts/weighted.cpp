#include "renderer/methods/parts/weighted.h"

namespace plume {
namespace {

constexpr std::array<float, 4> kZero{0, 0, 0, 0}, kOne{1, 1, 1, 1};

vk::Format through_format(const Weighted& weighted) {
  using enum Weighted::Revealage;
  const auto of = [&](vk::Format one, vk::Format four) { return weighted.each_channel ? four : one; };
  switch (weighted.revealage) {
    case kUnorm8:
      return of(vk::Format::eR8Unorm, vk::Format::eR8G8B8A8Unorm);
    case kAsSums:
      if (weighted.full_floats) return of(vk::Format::eR32Sfloat, vk::Format::eR32G32B32A32Sfloat);
      [[fallthrough]];
    case kHalf:
      return of(vk::Format::eR16Sfloat, vk::Format::eR16G16B16A16Sfloat);
    case kFloat:
      return of(vk::Format::eR32Sfloat, vk::Format::eR32G32B32A32Sfloat);
  }
  throw std::logic_error("unknown revealage");
}

std::vector<gpu::Attachment> three_targets(const Resources& resources, const std::string& end) {
  return {{.image = &resources.image("accum" + end), .blend = gpu::Blend::kAdd, .clear = kZero},
          {.image = &resources.image("through" + end), .blend = gpu::Blend::kMultiply, .clear = kOne},
          {.image = &resources.image("emission" + end), .blend = gpu::Blend::kAdd, .clear = kZero}};
}

}  // namespace

void Weighted::add_needs(Needs& needs) const {
  const vk::Format sums = full_floats ? vk::Format::eR32G32B32A32Sfloat : vk::Format::eR16G16B16A16Sfloat;
  const auto add = [&](const char* name, vk::Format format, uint32_t divisor) {
    needs.images.push_back({.name = name, .format = format, .usage = kTargetUsage, .divisor = divisor});
  };
  add("accum", sums, 1);
  add("through", through_format(*this), 1);
  add("emission", sums, 1);
  if (each_channel) add("norm", sums, 1);
  if (modulates) add("modulation", sums, 1);
  if (low_divisor > 1) {
    add("accum_low", sums, low_divisor);
    add("through_low", through_format(*this), low_divisor);
    add("emission_low", sums, low_divisor);
    needs.images.push_back(
        {.name = "low_depth",
         .format = vk::Format::eD32Sfloat,
         .usage = vk::ImageUsageFlagBits::eDepthStencilAttachment | vk::ImageUsageFlagBits::eSampled,
         .divisor = low_divisor});
  }
  needs.buffers.push_back({.name = "overflowed", .bytes = 4, .clear = 0});
}

std::vector<gpu::Attachment> Weighted::targets(const Resources& resources) const {
  std::vector<gpu::Attachment> all = three_targets(resources, "");
  if (each_channel)
    all.push_back({.image = &resources.image("norm"), .blend = gpu::Blend::kAdd, .clear = kZero});
  if (modulates)
    all.push_back({.image = &resources.image("modulation"), .blend = gpu::Blend::kMultiply, .clear = kOne});
  return all;
}

std::vector<gpu::Attachment> Weighted::low_targets(const Resources& resources) const {
  return three_targets(resources, "_low");
}

void Weighted::record_low_depth(const Picture& picture) const {
  const glm::uvec2 low = low_size(picture.size);
  picture.frame.pass("low_depth", [&](gpu::Pass& pass) {
    pass.draw({.vertex = "post/fullscreen.vert",
               .fragment = "surface/low_depth.frag",
               .targets = {},
               .depth = &low_depth(picture.resources),
               .depth_use = gpu::DepthUse::kTestAndWrite,
               .clear_depth = true,
               .area = {low.x, low.y},
               .constants = {low_divisor},
               .bindings = {{"full_depth", &picture.opaque_depth}}},
              0u);
  });
}

gpu::Bindings Weighted::sums(const Picture& picture) const {
  const auto image = [&](const char* name) { return &picture.resources.image(name); };
  const auto low = [&](const char* name, const char* full) { return image(low_divisor > 1 ? name : full); };
  return {{"accum", image("accum")},
          {"through", image("through")},
          {"emission", image("emission")},
          {"accum_low", low("accum_low", "accum")},
          {"through_low", low("through_low", "through")},
          {"emission_low", low("emission_low", "emission")},
          {"low_depth", low_divisor > 1 ? image("low_depth") : &picture.opaque_depth},
          {"full_depth", &picture.opaque_depth}};
}

void Weighted::record_resolve(const Picture& picture) const {
  const auto image = [&](const char* name) { return &picture.resources.image(name); };
  gpu::Bindings bindings = sums(picture);
  bindings.insert(bindings.end(), {{"norm", image(each_channel ? "norm" : "accum")},
                                   {"modulation", image(modulates ? "modulation" : "accum")},
                                   {"opaque_color", &picture.opaque_color},
                                   {"result", &picture.result},
                                   {"Overflowed", &picture.resources.buffer("overflowed")}});
  picture.frame.pass("resolve", [&](gpu::Pass& pass) {
    pass.dispatch(pass.pipelines().compute("methods/parts/weighted/resolve.comp",
                                           {each_channel ? 1u : 0u, normalise ? 1u : 0u, modulates ? 1u : 0u,
                                            low_divisor, full_floats ? 1u : 0u}),
                  bindings, picture.size,
                  {gpu::groups(picture.size.x, 8), gpu::groups(picture.size.y, 8), 1});
  });
}

void Weighted::record_outputs(const Picture& picture, const std::string& folder,
                              const gpu::Constants& constants) const {
  const auto draw = [&](const char* pass_name, const gpu::Image& output, Transparents::Style style) {
    style.targets = {{.image = &output, .blend = gpu::Blend::kAdd, .clear = kZero}};
    style.depth_test = style.opaque_depth = &picture.opaque_depth;
    style.area = picture.area();
    style.constants = constants;
    style.bindings = sums(picture);
    picture.frame.pass(pass_name, [&](gpu::Pass& pass) { picture.transparents.draw(pass, style); });
  };
  if (picture.distortion)
    draw("distortion", *picture.distortion,
         {.fragment = folder + "/haze.frag",
          .targets = {},
          .vertex = "surface/haze.vert",
          .source = Source::kHaze,
          .constants = {},
          .bindings = {}});
  if (picture.surface)
    draw("surface", *picture.surface,
         {.fragment = folder + "/surface.frag", .targets = {}, .constants = {}, .bindings = {}});
}

nlohmann::json Weighted::statistics(gpu::Device& device, const Resources& resources) const {
  return {{"overflowed_pixels", gpu::read<uint32_t>(device, resources.buffer("overflowed"))[0]}};
}

}  // namespace plume
