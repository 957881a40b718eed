// What is drawn over the picture: whose picture it is, and the divider between two.
#ifndef PLUME_DEBUGGER_VIEWPORT_MARKS_H
#define PLUME_DEBUGGER_VIEWPORT_MARKS_H

#include "sandbox/debugger/interface.h"

namespace plume {

void mark_viewport(Interface& interface, Area picture);

}  // namespace plume
#endif
