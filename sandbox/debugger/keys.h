// What keys do, and the list of them that F1 opens.
#ifndef PLUME_DEBUGGER_KEYS_H
#define PLUME_DEBUGGER_KEYS_H

#include "sandbox/debugger/interface.h"
#include "sandbox/window/input.h"

namespace plume {

/// Does what the key is for, if it is for anything.
void press(const KeyPress& pressed, Interface& interface);
/// The list of keys, while it is open.
void describe_keys(Interface& interface);

}  // namespace plume
#endif
