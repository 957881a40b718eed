// A curve over a particle's life: keys are dragged, a double click adds one, a right click takes one away.
// The chosen key shows its slopes as handles and all of its numbers.
#ifndef PLUME_DEBUGGER_CURVE_EDITOR_H
#define PLUME_DEBUGGER_CURVE_EDITOR_H

#include <optional>

#include "sandbox/presets/field.h"

struct ImDrawList;
struct ImVec2;

namespace plume {

/// As large as the room there is. Returns what became of the curve, if anything did.
std::optional<Curve> edit_curve(const Curve& curve, const Limits& limits);
/// The curve alone, in a box.
void draw_curve(ImDrawList& draw, const Curve& curve, const ImVec2& from, const ImVec2& to);

}  // namespace plume
#endif
