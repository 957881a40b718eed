// From the renderer's displayed picture to the window's image.
#ifndef PLUME_WINDOW_PICTURE_COPY_H
#define PLUME_WINDOW_PICTURE_COPY_H

#include "renderer/gpu/resources.h"
#include "sandbox/window/swapchain.h"

namespace plume {

/// Scales `picture` over all of `window`, whose content may be undefined, and leaves that in
/// COLOR_ATTACHMENT_OPTIMAL.
void record_picture_copy(const vk::raii::CommandBuffer& commands, const gpu::Image& picture,
                         const WindowImage& window);

}  // namespace plume
#endif
