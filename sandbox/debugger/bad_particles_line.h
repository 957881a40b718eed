// A line that points at the emitter whose particles are left out of the picture, because nothing can be drawn
// with their numbers. A click selects it.
#ifndef PLUME_DEBUGGER_BAD_PARTICLES_LINE_H
#define PLUME_DEBUGGER_BAD_PARTICLES_LINE_H

#include "sandbox/debugger/interface.h"

namespace plume {

/// Nothing where there are none.
void point_at_bad_particles(Interface& interface);

}  // namespace plume
#endif
