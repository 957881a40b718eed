// How a particle's optical depth lies in a light grid. A puff is a ball of even density and radius r; seen along an axis, the share of
// it below x is smoothstep((x / h + 1) / 2), exactly that of a ball of radius h. A cell's share is the product of three such differences:
// they sum to 1 wherever the lattice lies, so no light is gained or lost by where cells begin. h = max(r, half a cell).
// Opaque things smaller than that hide only their own disc: C = -pi h^2 ln(1 - (r / h)^2 (1 - exp(-tau))), which is tau pi r^2 at r = h.
// Limits: the product is rounder than a cube and less round than a ball: its middle is 18% denser than the ball's.
#ifndef PLUME_EFFECTS_LIGHT_BODY_GLSL
#define PLUME_EFFECTS_LIGHT_BODY_GLSL
#include "shared/light.h"

const float kLeastDepth = 0.002;   // thinner things cast nothing
const float kMostDepth = 8.0;      // 3 in 10 000 are left: thicker is no darker
const float kDepthUnit = 65536.0;  // of the fixed-point sums: exact in any order. Full at 5800 opaque puffs in one cell.

bool casts(LitBody body) { return body.depth > kLeastDepth; }

vec3 in_frame(LightGrid grid, vec3 world) { return vec3(dot(world, grid.axis_s), dot(world, grid.axis_t), dot(world, grid.axis_l)); }
vec3 in_cells(LightGrid grid, vec3 world) { return (in_frame(grid, world) - grid.origin) / grid.cell; }

// Half widths, in cells.
vec3 spread(LightGrid grid, LitBody body) { return max(vec3(body.radius) / grid.cell, vec3(0.5)); }

// Of a ball around 0 of radius 1.
float share_below(float x) { return smoothstep(-1.0, 1.0, x); }
float share_between(float a, float b, float middle, float half_width) {
  return share_below((b - middle) / half_width) - share_below((a - middle) / half_width);
}

// Optical depth that the body would give a single cell, were all of it in there.
float cell_depth(LightGrid grid, LitBody body, vec3 half_width) {
  const float area = 3.14159265 * half_width.x * half_width.y;   // in cells, of the disc that it is spread over
  const float part = min(3.14159265 * body.radius * body.radius / (grid.cell.x * grid.cell.y) / area, 1.0);
  const float tau = min(body.depth, kMostDepth);
  return -area * log(1.0 - part * (1.0 - exp(-tau)));
}

// What light_volume.glsl reads at the body's middle because of the body alone, interpolation included.
float own_depth(LightGrid grid, LitBody body) {
  const vec3 at = in_cells(grid, body.position), half_width = spread(grid, body);
  const vec2 low = floor(at.xy - 0.5), part = at.xy - 0.5 - low;
  vec2 across;
  for (int axis = 0; axis < 2; ++axis)
    across[axis] = mix(share_between(low[axis], low[axis] + 1.0, at[axis], half_width[axis]),
                       share_between(low[axis] + 1.0, low[axis] + 2.0, at[axis], half_width[axis]), part[axis]);
  const float face = floor(at.z);
  const float before = mix(share_below((face - at.z) / half_width.z), share_below((face + 1.0 - at.z) / half_width.z), at.z - face);
  return cell_depth(grid, body, half_width) * across.x * across.y * before;
}

#endif
