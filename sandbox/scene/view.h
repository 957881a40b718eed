// The camera and the light of a scene at a tick, as shaders see them.
#ifndef PLUME_SCENE_VIEW_H
#define PLUME_SCENE_VIEW_H

#include "sandbox/scene/scene.h"
#include "shaders/shared/view.h"

namespace plume {

/// `previous` is the camera of the tick before; nothing: it stood still.
shared::ViewData make_view(const Scene& scene, const CameraKey& camera, glm::uvec2 size, uint32_t tick,
                           const std::optional<CameraKey>& previous = {});

}  // namespace plume
#endif
