// Multi-layer alpha blending by a spin lock: see methods/mlab/insert.glsl.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "surface/shade.glsl"
#include "methods/parts/pixel_nodes/spinlock.glsl"
#include "methods/mlab/insert.glsl"

void main() {
  Fragment f;
  const bool seen = shade_seen(f);
  wait_for_turn(seen, f);
}
