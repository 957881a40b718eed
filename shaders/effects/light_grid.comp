// Lays both light grids over what casts. So that nothing swims or flickers while a cloud grows, cells are a power of sqrt(2) wide and
// begin at a multiple of that. They are no finer than the largest puff asks for, so that it covers few of them, and one cell of margin
// is empty all around: what lies outside reads the edge.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "effects/light_frame.glsl"
#include "shared/view.h"

layout(local_size_x = 1) in;
layout(scalar, binding = 0) uniform View { ViewData view; };
layout(scalar, binding = 2) readonly buffer Bounds { uint bounds[]; };
layout(scalar, binding = 3) writeonly buffer Grids { LightGrid grids[]; };
layout(push_constant) uniform Push {
  uvec2 cells;              // of each grid
  vec2 cells_a_radius;      // of the largest puff, at most
};

void main() {
  const uint which = gl_GlobalInvocationID.x;
  LightGrid grid = light_frame(which, view.sun_direction);
  grid.cells = cells[which];
  const uint first = which * kLightBounds;
  if (bounds[first + 6u] != 0xFFFFFFFFu) {   // otherwise nothing casts at this tick
    const float finest = from_ordered(~bounds[first + 6u]) / cells_a_radius[which];
    for (uint axis = 0u; axis < 3u; ++axis) {
      const float least = from_ordered(bounds[first + axis]), most = from_ordered(~bounds[first + 3u + axis]);
      const float needed = max((most - least) / float(grid.cells - 5u), finest);
      grid.cell[axis] = exp2(ceil(log2(needed) * 2.0) * 0.5);
      grid.origin[axis] = (floor(least / grid.cell[axis]) - 2.0) * grid.cell[axis];
    }
  }
  grids[which] = grid;
}
