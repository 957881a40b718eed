// The panels of the window: where they stand, and the list of them.
#ifndef PLUME_DEBUGGER_PANELS_H
#define PLUME_DEBUGGER_PANELS_H

#include "sandbox/debugger/interface.h"

namespace plume {

/// Describes all panels, with ImGui. Returns what they leave of the window to the picture.
Area describe_panels(Interface& interface);

}  // namespace plume
#endif
