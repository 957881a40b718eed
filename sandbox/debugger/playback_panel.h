// Which scene is shown at which tick, how fast it plays, and the keys.
#ifndef PLUME_DEBUGGER_PLAYBACK_PANEL_H
#define PLUME_DEBUGGER_PLAYBACK_PANEL_H

#include <glm/glm.hpp>
#include <optional>

#include "sandbox/scene/scene.h"
#include "sandbox/window/playback.h"

namespace plume {

struct PlaybackFacts {
  std::string device;
  glm::uvec2 picture_size;
  double frame_ms;  ///< from one drawn picture to the next; 0 = not known yet
};

/// `camera` is the user's own, or nothing while the scene's is followed. True when the picture must be drawn
/// anew.
bool playback_panel(const Scene& scene, const PlaybackFacts& facts, Playback& playback,
                    std::optional<CameraKey>& camera);

}  // namespace plume
#endif
