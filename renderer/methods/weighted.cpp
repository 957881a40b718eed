#include "renderer/methods/weighted.h"

namespace plume {

void Weighted::add_needs(Needs& needs) const {
  const vk::Format sums = full_floats ? vk::Format::eR32G32B32A32Sfloat : vk::Format::eR16G16B16A16Sfloat;
  const vk::Format one = full_floats ? vk::Format::eR32Sfloat : vk::Format::eR16Sfloat;
  needs.images.push_back({.name = "accum", .format = sums, .usage = kTargetUsage});
  needs.images.push_back({.name = "through", .format = each_channel ? sums : one, .usage = kTargetUsage});
  needs.images.push_back({.name = "emission", .format = sums, .usage = kTargetUsage});
  if (each_channel) needs.images.push_back({.name = "norm", .format = sums, .usage = kTargetUsage});
}

std::vector<gpu::Attachment> Weighted::targets(const Resources& resources) const {
  constexpr std::array<float, 4> kZero{0, 0, 0, 0}, kOne{1, 1, 1, 1};
  std::vector<gpu::Attachment> all{
      {.image = &resources.image("accum"), .blend = gpu::Blend::kAdd, .clear = kZero},
      {.image = &resources.image("through"), .blend = gpu::Blend::kMultiply, .clear = kOne},
      {.image = &resources.image("emission"), .blend = gpu::Blend::kAdd, .clear = kZero}};
  if (each_channel)
    all.push_back({.image = &resources.image("norm"), .blend = gpu::Blend::kAdd, .clear = kZero});
  return all;
}

void Weighted::record_resolve(const Picture& picture) const {
  const auto image = [&](const char* name) { return &picture.resources.image(name); };
  picture.frame.pass("resolve", [&](gpu::Pass& pass) {
    pass.dispatch(pass.pipelines().compute("methods/weighted/resolve.comp",
                                           {each_channel ? 1u : 0u, normalise ? 1u : 0u}),
                  {{"accum", image("accum")},
                   {"through", image("through")},
                   {"emission", image("emission")},
                   {"norm", image(each_channel ? "norm" : "accum")},
                   {"opaque_color", &picture.opaque_color},
                   {"result", &picture.result}},
                  picture.size, {gpu::groups(picture.size.x, 8), gpu::groups(picture.size.y, 8), 1});
  });
}

}  // namespace plume
