// Bounds of all bodies that cast, in the frames of both light grids, and their greatest radius. Minima of integers: the order of
// threads does not matter. Greatest values are least complements.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "effects/light_body.glsl"
#include "effects/light_frame.glsl"
#include "shared/view.h"

layout(local_size_x = 64) in;
layout(scalar, binding = 0) uniform View { ViewData view; };
layout(scalar, binding = 1) readonly buffer Bodies { LitBody bodies[]; };
layout(scalar, binding = 2) buffer Bounds { uint bounds[]; };   // starts with all bits set
layout(push_constant) uniform Push {
  uint count;
  uint threads;
};

const float kFar = 1e30;

void main() {
  for (uint g = 0u; g < kLightGrids; ++g) {
    const LightGrid grid = light_frame(g, view.sun_direction);
    vec3 least = vec3(kFar), most = vec3(-kFar);
    float radius = 0.0;
    for (uint i = gl_GlobalInvocationID.x; i < count; i += threads) {
      const LitBody body = bodies[i];
      if (!casts(body)) continue;
      const vec3 at = in_frame(grid, body.position);
      least = min(least, at - body.radius);
      most = max(most, at + body.radius);
      radius = max(radius, body.radius);
    }
    if (radius == 0.0) continue;
    for (uint axis = 0u; axis < 3u; ++axis) {
      atomicMin(bounds[g * kLightBounds + axis], ordered(least[axis]));
      atomicMin(bounds[g * kLightBounds + 3u + axis], ~ordered(most[axis]));
    }
    atomicMin(bounds[g * kLightBounds + 6u], ~ordered(radius));
  }
}
