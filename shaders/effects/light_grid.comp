// Lays both light grids over what casts. Cells grow with the cloud from tick to tick, evenly: steps of any size would be seen as a jump.
// They are no finer than the largest puff asks for, so that it covers few of them, and a margin of cells is empty all around: what lies
// outside reads the edge.
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

const uint kMargin = 2u;   // cells: interpolation reaches half a cell beyond what narrow puffs are spread over

void main() {
  const uint which = gl_GlobalInvocationID.x;
  LightGrid grid = light_frame(which, view.sun_direction);
  grid.cells = cells[which];
  const uint first = which * kLightBounds;
  if (bounds[first + 6u] != 0xFFFFFFFFu) {   // otherwise nothing casts at this tick
    const float finest = from_ordered(~bounds[first + 6u]) / cells_a_radius[which];
    for (uint axis = 0u; axis < 3u; ++axis) {
      const float least = from_ordered(bounds[first + axis]), most = from_ordered(~bounds[first + 3u + axis]);
      grid.cell[axis] = max((most - least) / float(grid.cells - 2u * kMargin), finest);
      grid.origin[axis] = least - float(kMargin) * grid.cell[axis];
    }
  }
  grids[which] = grid;
}
