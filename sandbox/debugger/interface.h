// What the panels are about: the workspace, and what concerns the window alone.
#ifndef PLUME_DEBUGGER_INTERFACE_H
#define PLUME_DEBUGGER_INTERFACE_H

#include "sandbox/debugger/effect_selection.h"
#include "sandbox/workspace/crosshair.h"
#include "sandbox/workspace/recording.h"
#include "sandbox/workspace/settings.h"

namespace plume {

/// In ImGui's coordinates, from the upper left.
struct Area {
  glm::vec2 corner, size;
};

/// How the crosshair's panel shows what it knows.
struct DepthGraph {
  bool logarithmic = true;
  bool each_channel = false;       ///< otherwise the mean of the three
  std::optional<size_t> fragment;  ///< that is pointed out
};
struct CrosshairView {
  DepthGraph graph{};
  size_t weights_of = 0;  ///< among the methods told: whose weights the table has
};

struct Interface {
  Workspace& workspace;
  Crosshair crosshair{};
  CrosshairView crosshair_view{};
  EffectSelection effects;

  bool panels = true;  ///< otherwise the picture has the whole window
  bool help = false;   ///< the list of keys is open
  bool full_screen = false;
  bool closing = false;
  float text_scale = 1.0f;  ///< the user's, besides that of the monitor
  Recording recording{};
  Settings settings{};  ///< of the last session; those of this one are taken when it ends
  bool has_ffmpeg = Video::is_available();
};

}  // namespace plume
#endif
