// What the picture costs: milliseconds of each pass, memory of each owner.
#ifndef PLUME_DEBUGGER_TIMINGS_PANEL_H
#define PLUME_DEBUGGER_TIMINGS_PANEL_H

#include "sandbox/debugger/interface.h"

namespace plume {

void timings_panel(Interface& interface);

}  // namespace plume
#endif
