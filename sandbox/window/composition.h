// Pictures in the window's image: one, or parts of several side by side.
#ifndef PLUME_WINDOW_COMPOSITION_H
#define PLUME_WINDOW_COMPOSITION_H

#include <span>

#include "renderer/gpu/resources.h"
#include "sandbox/window/swapchain.h"

namespace plume {

struct PlacedPicture {
  const gpu::Image* picture;
  float from = 0.0f, to = 1.0f;  ///< what is shown of it, shares of its width
  vk::Rect2D at;                 ///< where, in pixels of the window; cut off at its edges
};

/// Fills the window's image: the pictures, stretched to their places, on a dark ground. The pictures are
/// finished and in the general layout; the image ends as a color attachment.
void record_composition(const vk::raii::CommandBuffer& commands, std::span<const PlacedPicture> pictures,
                        const WindowImage& window);

}  // namespace plume
#endif
