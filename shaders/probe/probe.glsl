// A method's probe shader defines probe_transmittance() with the functions that its draw uses, and includes this.
#ifndef PLUME_PROBE_GLSL
#define PLUME_PROBE_GLSL
#include "probe/probe.h"

layout(local_size_x = 64) in;
layout(scalar, binding = 30) readonly buffer ProbePoints {
  ProbeQuery query;
  ProbedPoint points[];
};
layout(scalar, binding = 31) writeonly buffer ProbeAnswer { vec3 answer[]; };

ProbedPoint probed;   // what is asked for now

// What the method believes passes from `depth` to the camera, for each channel: what `probed` is drawn with there.
vec3 probe_transmittance(uvec2 pixel, float depth);

void main() {
  const uint i = gl_GlobalInvocationID.x;
  if (i >= query.count) return;
  probed = points[i];
  answer[i] = probe_transmittance(query.pixel, probed.depth);
}

#endif
