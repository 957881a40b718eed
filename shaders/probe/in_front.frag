// The probe of methods that keep no function of depth: every fragment at the pixel dims all points that it lies in front of.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "surface/shade.glsl"
#include "shared/card.h"
#include "probe/probe.h"

layout(early_fragment_tests) in;
layout(constant_id = 0) const uint kByCenter = 0u;   // in front by its card's centre, as sorting takes it
layout(scalar, binding = 1) readonly buffer Cards { Card cards[]; };
layout(scalar, binding = 30) readonly buffer ProbePoints {
  ProbeQuery query;
  ProbedPoint points[];
};
layout(scalar, binding = 31) buffer ProbeAnswer { uint answer[]; };   // bits of floats, three a point

void multiply(uint at, float by) {
  uint seen = answer[at], was;
  do {
    was = seen;
    seen = atomicCompSwap(answer[at], was, floatBitsToUint(uintBitsToFloat(was) * by));
  } while (seen != was);
}

// Of a fragment of a card at `depth`.
float place_of(uint card, float depth) {
  return kByCenter != 0u && card != kBareLight ? dot(cards[card].center - view.camera, view.forward) : depth;
}

void main() {
  if (uvec2(gl_FragCoord.xy) != query.pixel) return;
  const Fragment f = shade();
  const float place = place_of(f.id, f.depth);
  const vec3 t = transmittance(f);
  for (uint i = 0u; i < query.count; ++i)
    if (place < place_of(points[i].card, points[i].depth))
      for (uint c = 0u; c < 3u; ++c) multiply(3u * i + c, t[c]);
}
