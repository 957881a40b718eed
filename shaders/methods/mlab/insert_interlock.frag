// Multi-layer alpha blending by fragment shader interlock, in the order of the draw: see methods/mlab/insert.glsl.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_ARB_fragment_shader_interlock : require
#include "surface/shade.glsl"
#include "methods/parts/pixel_nodes/interlock.glsl"
#include "methods/mlab/insert.glsl"

layout(pixel_interlock_ordered) in;

void main() {
  Fragment f;
  const bool seen = shade_seen(f);
  beginInvocationInterlockARB();
  interlocked_turn(seen, f);
  endInvocationInterlockARB();
}
