// The scene's effects: who is awake and why, what each costs, solo, mute and freeze; and the fields of the
// one that is selected, with undo and saving.
#ifndef PLUME_DEBUGGER_EFFECTS_PANEL_H
#define PLUME_DEBUGGER_EFFECTS_PANEL_H

#include "sandbox/debugger/interface.h"

namespace plume {

void effects_panel(Interface& interface);
/// Questions about files that stand over the picture until they are answered.
void ask_about_files(Interface& interface);

// What keys do, too; nothing where no effect is selected.
void undo_edit(Interface& interface);
void redo_edit(Interface& interface);
void save_effect(Interface& interface);
/// Closes the window, once what is not saved is decided.
void close_window(Interface& interface);
/// Drops the effect that is being placed; `place` are shares of the picture of `side`. False: none is.
bool place_effect(Interface& interface, Side& side, glm::vec2 place);

}  // namespace plume
#endif
