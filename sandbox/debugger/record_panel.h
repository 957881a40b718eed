// Records the session as a replay, saves pictures and videos.
#ifndef PLUME_DEBUGGER_RECORD_PANEL_H
#define PLUME_DEBUGGER_RECORD_PANEL_H

#include "sandbox/debugger/interface.h"

namespace plume {

void record_panel(Interface& interface);

}  // namespace plume
#endif
