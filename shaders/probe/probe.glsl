// A method's probe shader defines transmittance_at() with the functions that its draw uses, and includes this.
#ifndef PLUME_PROBE_GLSL
#define PLUME_PROBE_GLSL
#include "probe/probe.h"

layout(local_size_x = 64) in;
layout(scalar, binding = 30) readonly buffer ProbeDepths {
  ProbeQuery query;
  float depths[];   // view depths, m
};
layout(scalar, binding = 31) writeonly buffer ProbeAnswer { vec3 answer[]; };

// What the method believes passes from `depth` to the camera, for each channel. Nothing of its own lies at that depth.
vec3 probe_transmittance(uvec2 pixel, float depth);

void main() {
  const uint i = gl_GlobalInvocationID.x;
  if (i < query.count) answer[i] = probe_transmittance(query.pixel, depths[i]);
}

#endif
