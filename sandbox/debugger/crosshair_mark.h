// The crosshair over the picture: a box round its pixel, and four arms.
#ifndef PLUME_DEBUGGER_CROSSHAIR_MARK_H
#define PLUME_DEBUGGER_CROSSHAIR_MARK_H

#include "sandbox/debugger/interface.h"

namespace plume {

void mark_crosshair(const Interface& interface, Area picture);

}  // namespace plume
#endif
