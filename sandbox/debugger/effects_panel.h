// The scene's effects: who is awake and why, what each costs, solo, mute and freeze; and the fields of the
// one that is selected, with undo and saving.
#ifndef PLUME_DEBUGGER_EFFECTS_PANEL_H
#define PLUME_DEBUGGER_EFFECTS_PANEL_H

#include "sandbox/debugger/interface.h"

namespace plume {

void effects_panel(Interface& interface);
/// In the scene that is shown; nothing: none is, or it is gone.
std::optional<size_t> selected_instance(const Interface& interface);
/// Or one of its emitters.
void select_instance(Interface& interface, size_t index, std::optional<size_t> emitter = {});

// What keys do, too: of the selected effect, if there is one, and of the scene.
void undo_edit(Interface& interface);
void redo_edit(Interface& interface);
void save_edits(Interface& interface);

}  // namespace plume
#endif
