// Which method draws, with its parameters; a second one beside it when two are compared.
#ifndef PLUME_DEBUGGER_METHOD_PANEL_H
#define PLUME_DEBUGGER_METHOD_PANEL_H

#include "sandbox/debugger/interface.h"

namespace plume {

void method_panel(Interface& interface);

}  // namespace plume
#endif
