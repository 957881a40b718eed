// Where AVBOIT's slices, its zero-transmittance depth and its first overflow lie at a pixel: read from what
// the frame left behind, for people who look at one pixel.
#include <algorithm>
#include <cmath>

#include "renderer/methods/avboit/plan.h"
#include "shaders/methods/avboit/zero_tile.h"
#include "shaders/shared/view.h"

namespace plume::avboit {
namespace {

/// The table from depth to physical slice, on the host.
struct WarpTable {
  shared::DepthWarp head;
  std::span<const float> ends;   ///< of physical slices, m
  std::span<const float> nodes;  ///< physical slices in front of each virtual one

  explicit WarpTable(std::span<const std::byte> bytes) {
    std::memcpy(&head, bytes.data(), sizeof(head));
    const auto* floats = reinterpret_cast<const float*>(bytes.data() + sizeof(head));
    ends = {floats, head.used};
    nodes = {floats + shared::kMostSlices, head.virtual_slices + 1u};
  }

  /// Depth, m, at which a physical slice begins: inside a virtual one places rise linearly.
  float begin_of(uint32_t slice, const shared::Volume& volume) const {
    const auto behind =
        std::ranges::upper_bound(nodes, float(slice));  // past the virtual slice that holds it
    if (behind == nodes.end() || behind == nodes.begin()) return 0.0f;
    const float first = *(behind - 1), width = *behind - first;
    const float place = float(behind - 1 - nodes.begin()) + (float(slice) - first) / width;
    return volume.curve_a * (std::exp2(place / head.scale) - 1.0f);
  }
};

}  // namespace

DepthMarks depth_marks(gpu::Device& device, const Resources& resources, const Plan& plan,
                       const Transparents& transparents, glm::uvec2 pixel) {
  const auto words = [&](const char* name) { return gpu::read<uint32_t>(device, resources.buffer(name)); };
  const shared::Volume& volume = plan.volume;
  const auto bytes = gpu::read_bytes(device, resources.buffer("warp"));
  const WarpTable warp{bytes};
  DepthMarks marks;
  for (uint32_t slice = 0; slice < warp.head.used; ++slice)
    marks.slices.push_back({warp.begin_of(slice, volume), warp.ends[slice]});

  if (plan.settings.zero_depth != ZeroDepth::kOff) {
    const auto view = gpu::read<shared::ViewData>(device, *transparents.view)[0];
    const glm::uvec2 tile = pixel / shared::kZeroTilePixels;
    const uint32_t across = (plan.size.x + shared::kZeroTilePixels - 1) / shared::kZeroTilePixels;
    const float reversed =
        gpu::read<float>(device, resources.buffer("zero_depths"))[tile.y * across + tile.x];
    if (reversed > 0.0f) marks.zero_m = view.near_m / reversed;
  }

  const glm::uvec2 cell = pixel / volume.divisor;
  const uint32_t ray = cell.y * volume.cells.x + cell.x;
  uint32_t first = words("overflow")[ray];
  if (plan.rgb_words() == 1) {
    const auto rgb = words("overflow_rgb");
    for (uint32_t channel = 0; channel < 3; ++channel) first = std::min(first, rgb[3 * ray + channel]);
  }
  if (first < warp.head.used) marks.overflow_m = marks.slices[first].begin;
  return marks;
}

}  // namespace plume::avboit
