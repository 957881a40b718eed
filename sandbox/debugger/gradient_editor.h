// Colours over a particle's life: marks under the bar are dragged, a double click on the bar adds one, a
// right click takes one away. The chosen one shows its numbers.
#ifndef PLUME_DEBUGGER_GRADIENT_EDITOR_H
#define PLUME_DEBUGGER_GRADIENT_EDITOR_H

#include <optional>

#include "sandbox/presets/field.h"

struct ImDrawList;
struct ImVec2;

namespace plume {

/// As wide as the room there is. Returns what became of the gradient, if anything did.
std::optional<Gradient> edit_gradient(const Gradient& gradient, const Limits& limits);
/// In a box; what is brighter than a screen is scaled to it as a whole.
void draw_gradient(ImDrawList& draw, const Gradient& gradient, const ImVec2& from, const ImVec2& to);

}  // namespace plume
#endif
