// The key to a side's view, over the picture: what its colours and patterns stand for, on which scale, and
// what the pixel under the pointer says.
#ifndef PLUME_DEBUGGER_VIEW_KEY_H
#define PLUME_DEBUGGER_VIEW_KEY_H

#include "sandbox/debugger/interface.h"

namespace plume {

/// Of every side that shows a view, behind the panels.
void mark_views(Interface& interface, Area picture);

}  // namespace plume
#endif
