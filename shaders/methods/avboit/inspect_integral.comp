// A look at AVBOIT's integral: the transmittance behind one slice, filtered across cells as draws read it, the mean of the channels. The
// exact layers are not in it.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/view.h"

layout(scalar, binding = 0) uniform View { ViewData view; };

#include "methods/avboit/integrated.glsl"
#include "inspect/inspect.glsl"

bool inspect(uvec2 pixel, out float value) {
  value = 1.0;
  if (look.slice >= warp.used) return false;
  const float place = integrated(tile_of(pixel), float(look.slice));
  if (place < 0.0) return true;
  const mat3x2 nodes = nodes_of((vec2(pixel) + 0.5) / vec2(volume.cells * volume.divisor), uint(place));
  const vec3 behind = vec3(nodes[0].y, nodes[1].y, nodes[2].y), t = kSampling == 4u ? exp(-behind) : behind;
  value = kRgb != 0u ? dot(t, vec3(1.0 / 3.0)) : t.r;
  return true;
}
