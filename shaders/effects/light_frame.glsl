// The frames of light grids, and floats as integers of the same order.
#ifndef PLUME_EFFECTS_LIGHT_FRAME_GLSL
#define PLUME_EFFECTS_LIGHT_FRAME_GLSL
#include "shared/light.h"

// 0: along the sun's light; 1: straight down.
LightGrid light_frame(uint which, vec3 to_sun) {
  LightGrid grid;
  grid.axis_l = which == 0u ? -to_sun : vec3(0.0, -1.0, 0.0);
  const vec3 aside = abs(grid.axis_l.y) < 0.99 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0);
  grid.axis_s = normalize(cross(aside, grid.axis_l));
  grid.axis_t = cross(grid.axis_l, grid.axis_s);
  grid.origin = vec3(0.0);
  grid.cell = vec3(1.0);
  grid.cells = 0u;
  return grid;
}

uint ordered(float value) {
  const uint bits = floatBitsToUint(value);
  return (bits & 0x80000000u) != 0u ? ~bits : bits | 0x80000000u;
}

float from_ordered(uint key) { return uintBitsToFloat((key & 0x80000000u) != 0u ? key & 0x7FFFFFFFu : ~key); }

#endif
