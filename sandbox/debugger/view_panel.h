// What the sides show instead of their pictures: which view, which slice, on which scale; its legend over the
// picture, and the number under the pointer.
#ifndef PLUME_DEBUGGER_VIEW_PANEL_H
#define PLUME_DEBUGGER_VIEW_PANEL_H

#include "sandbox/debugger/interface.h"

namespace plume {

void view_panel(Interface& interface);
void mark_views(Interface& interface, Area picture);

}  // namespace plume
#endif
