// The fragments of the one pixel that is drawn, in any order, as every method is given them.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "surface/shade.glsl"
#include "probe/probe.h"

layout(early_fragment_tests) in;
layout(scalar, binding = 8) buffer ProbedFragments {
  ProbedCount found;
  ProbedFragment fragments[];
};

void main() {
  const Fragment f = shade();
  if (f.coverage == 0.0 && f.emission == vec3(0.0)) return;   // changes nothing, exactly
  const uint slot = atomicAdd(found.count, 1u);
  if (slot < found.capacity) fragments[slot] = ProbedFragment(f.color, f.coverage, f.emission, f.depth, transmittance(f), f.id);
}
