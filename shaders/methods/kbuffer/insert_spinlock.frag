// k-buffer by a spin lock: see methods/kbuffer/insert.glsl.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "surface/shade.glsl"
#include "methods/parts/pixel_nodes/spinlock.glsl"
#include "methods/kbuffer/insert.glsl"

void main() {
  Fragment f;
  const bool seen = shade_seen(f);
  wait_for_turn(seen, f);
  write_evicted();
}
