// What is at the crosshair: transmittance over depth, and a table of the fragments there.
#ifndef PLUME_DEBUGGER_CROSSHAIR_PANEL_H
#define PLUME_DEBUGGER_CROSSHAIR_PANEL_H

#include "sandbox/debugger/interface.h"

namespace plume {

void crosshair_panel(Interface& interface);

}  // namespace plume
#endif
