// Which tick is shown and how fast it plays, how fine the picture is.
#ifndef PLUME_DEBUGGER_TIMELINE_H
#define PLUME_DEBUGGER_TIMELINE_H

#include "sandbox/debugger/interface.h"

namespace plume {

void timeline(Interface& interface);

}  // namespace plume
#endif
