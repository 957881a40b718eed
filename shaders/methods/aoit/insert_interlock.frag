// AOIT's visibility function by fragment shader interlock: see methods/aoit/insert.glsl. Any order will do.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_ARB_fragment_shader_interlock : require
#include "surface/shade.glsl"
#include "methods/parts/pixel_nodes/interlock.glsl"
#include "methods/aoit/insert.glsl"

layout(pixel_interlock_unordered) in;

void main() {
  Fragment f;
  const bool seen = shade_seen(f);
  beginInvocationInterlockARB();
  interlocked_turn(seen && dims(f), f);
  endInvocationInterlockARB();
}
