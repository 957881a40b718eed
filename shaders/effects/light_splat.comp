// Adds each body's optical depth to the cells of a light grid that it covers, see effects/light_body.glsl. Integers: the sums are the same
// in every order.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "effects/light_body.glsl"

layout(local_size_x = 64) in;
layout(scalar, binding = 1) readonly buffer Bodies { LitBody bodies[]; };
layout(scalar, binding = 3) readonly buffer Grids { LightGrid grids[]; };
layout(scalar, binding = 4) buffer Cells { uint cells[]; };   // s fastest, starts with zeros
layout(push_constant) uniform Push {
  uint count;
  uint which;
};

void main() {
  const uint i = gl_GlobalInvocationID.x;
  if (i >= count) return;
  const LitBody body = bodies[i];
  if (!casts(body)) return;
  const LightGrid grid = grids[which];
  const vec3 at = in_cells(grid, body.position), half_width = spread(grid, body);
  const float depth = cell_depth(grid, body, half_width) * kDepthUnit;
  const ivec3 last = ivec3(grid.cells - 1u);
  const ivec3 low = clamp(ivec3(floor(at - half_width)), ivec3(0), last), high = clamp(ivec3(floor(at + half_width)), ivec3(0), last);
  for (int l = low.z; l <= high.z; ++l) {
    const float along = depth * share_between(float(l), float(l + 1), at.z, half_width.z);
    for (int t = low.y; t <= high.y; ++t) {
      const float row = along * share_between(float(t), float(t + 1), at.y, half_width.y);
      for (int s = low.x; s <= high.x; ++s) {
        const uint units = uint(row * share_between(float(s), float(s + 1), at.x, half_width.x) + 0.5);
        if (units > 0u) atomicAdd(cells[(uint(l) * grid.cells + uint(t)) * grid.cells + uint(s)], units);
      }
    }
  }
}
