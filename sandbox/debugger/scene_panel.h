// Which scene is shown, and by which camera.
#ifndef PLUME_DEBUGGER_SCENE_PANEL_H
#define PLUME_DEBUGGER_SCENE_PANEL_H

#include "sandbox/debugger/interface.h"

namespace plume {

void scene_panel(Interface& interface);
/// The question that stands over the picture while a copy of the scene is named.
void ask_for_scene_name(Interface& interface);

}  // namespace plume
#endif
