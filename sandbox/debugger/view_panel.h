// What the sides show instead of their pictures: which view, which slice, on which scale.
#ifndef PLUME_DEBUGGER_VIEW_PANEL_H
#define PLUME_DEBUGGER_VIEW_PANEL_H

#include "sandbox/debugger/interface.h"

namespace plume {

void view_panel(Interface& interface);

}  // namespace plume
#endif
