#include "renderer/methods/avboit/plan.h"
#include "shaders/methods/avboit/zero_tile.h"

namespace plume::avboit {

nlohmann::json statistics(gpu::Device& device, const Resources& resources, const Plan& plan) {
  const auto words = [&](const char* name) { return gpu::read<uint32_t>(device, resources.buffer(name)); };
  const auto noted = [](auto first, auto last) {
    return uint64_t(last - first - std::count(first, last, shared::kNoOverflow));
  };
  const auto warp = gpu::read<shared::DepthWarp>(device, resources.buffer("warp"))[0];
  const auto overflow = words("overflow");
  nlohmann::json result{{"virtual_slices", warp.virtual_slices},
                        {"virtual_slices_asked", plan.settings.virtual_slices_asked()},
                        {"virtual_slices_lacking",
                         std::max(plan.settings.virtual_slices_asked() - shared::kMostVirtualSlices, 0.0)},
                        {"slices_used", warp.used},
                        {"slices_apart_dropped", warp.apart_dropped},
                        {"rays", plan.rays()},
                        {"rays_overflowed", noted(overflow.begin(), overflow.end())}};
  if (plan.rgb_words() == 1) {
    const auto rgb = words("overflow_rgb");
    const auto carries = rgb.begin() + int64_t(plan.rays() * 3);
    result["rgb_channels_overflowed"] = noted(rgb.begin(), carries);
    result["rgb_rays_carried"] = noted(carries, rgb.end());
  }
  if (plan.watches_overlap()) result["pixels_sharing_a_slice"] = words("flagged")[0];
  if (plan.volume.exact_layers > 0) result["layers_merged"] = words("layer_tails").front();
  if (plan.settings.zero_depth != ZeroDepth::kOff) result["zero_tiles"] = words("zero_draw")[1];
  return result;
}

}  // namespace plume::avboit
