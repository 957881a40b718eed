// A linear colour: three numbers, and a swatch that opens a picker. What is brighter than a screen can be
// shown in its hue, and keeps its brightness while the hue is picked.
#ifndef PLUME_DEBUGGER_COLOR_EDITOR_H
#define PLUME_DEBUGGER_COLOR_EDITOR_H

#include <imgui.h>

#include "sandbox/presets/field.h"

namespace plume {

/// As a screen takes it, of a colour whose brightest channel may be `most`.
ImU32 shown_color(glm::vec3 linear, float most = 1.0f);

/// Takes the next item's width; returns whether the colour is another now.
bool edit_color(const char* id, glm::vec3& linear, const Limits& limits);

}  // namespace plume
#endif
