// Which scene is shown, and by which camera.
#ifndef PLUME_DEBUGGER_SCENE_PANEL_H
#define PLUME_DEBUGGER_SCENE_PANEL_H

#include "sandbox/debugger/interface.h"

namespace plume {

void scene_panel(Interface& interface);

}  // namespace plume
#endif
