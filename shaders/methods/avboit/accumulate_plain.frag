// AVBOIT, draw: the same of what does not tint, and needs no sum for it.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "methods/avboit/accumulate.glsl"

layout(location = 0) out vec4 light;
layout(location = 1) out vec4 norm;
layout(location = 2) out vec4 known_light;
layout(location = 3) out vec4 known_norm;

void main() {
  const Share share = share_of_fragment();
  light = share.light;
  norm = vec4(share.norm, 0.0);
  known_light = vec4(share.known_light, kEachChannel != 0u ? 0.0 : share.known_norm.r);
  known_norm = vec4(share.known_norm, 0.0);
}
