// What the panels are about: the workspace, and what concerns the window alone.
#ifndef PLUME_DEBUGGER_INTERFACE_H
#define PLUME_DEBUGGER_INTERFACE_H

#include "sandbox/workspace/workspace.h"

namespace plume {

/// In ImGui's coordinates, from the upper left.
struct Area {
  glm::vec2 corner, size;
};

struct Interface {
  Workspace& workspace;

  bool panels = true;  ///< otherwise the picture has the whole window
  bool help = false;   ///< the list of keys is open
  bool full_screen = false;
  bool closing = false;
};

}  // namespace plume
#endif
