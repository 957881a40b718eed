// Counts the pieces of one draw of opaque particles that cannot be drawn: opaque/debris.vert leaves them out.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "effects/debris.h"
#include "effects/particle.glsl"

layout(local_size_x = kSpanGroup) in;
layout(scalar, binding = 3) readonly buffer Particles { Particle particles[]; };
layout(scalar, binding = 9) buffer Bad { BadCards bad; };
layout(push_constant, scalar) uniform Push {
  DebrisDraw drawn;
  uint count;
  uint first_index;   // of BadCards
};

void main() {
  const uint index = gl_GlobalInvocationID.x;
  if (index >= count) return;
  const Particle p = particles[slot_of(drawn, index)];
  if (age_of(p) == kDeadAge || generation_of(p) > 0u || !is_bad(p)) return;
  atomicAdd(bad.count, 1u);
  atomicMin(bad.first, first_index + index);
}
