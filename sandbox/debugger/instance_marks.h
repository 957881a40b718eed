// Instances of effects in the picture: where the one that is being placed would stand, where the one that is
// selected stands, and taking hold of that to move it.
#ifndef PLUME_DEBUGGER_INSTANCE_MARKS_H
#define PLUME_DEBUGGER_INSTANCE_MARKS_H

#include "sandbox/debugger/interface.h"

namespace plume {

/// Draws the marks over the picture.
void mark_instances(Interface& interface, Area picture);

/// Drops the effect that is being placed; `place` are shares of the picture. False: none is.
bool place_effect(Interface& interface, glm::vec2 place, bool goes_on);
/// Takes hold of the selected instance where its mark is at a point of the window. False: it is not.
bool grab_instance(Interface& interface, glm::vec2 at);
/// What is held follows the pointer: on the level where it was taken, or with `upright` on the upright plane
/// that faces the camera. One step of undo until let go.
void drag_instance(Interface& interface, glm::vec2 to, bool upright);
void let_go_of_instance(Interface& interface);

/// Takes the selected instance out of the scene.
void remove_instance(Interface& interface);
/// Turns the camera to what is seen at a place of the picture, and selects the instance whose that is.
void focus_at(Interface& interface, glm::vec2 place);
/// Frames the selected instance; where none is, focuses on what is under the pointer.
void focus_or_frame(Interface& interface);

}  // namespace plume
#endif
