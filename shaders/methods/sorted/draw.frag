// Alpha blending of sorted cards ("No OIT"):  image = L + t * what is behind, with RGB transmission by dual-source blending.
// Limits: cards are sorted by their centres, so interpenetrating ones are wrong.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "surface/shade.glsl"

layout(location = 0, index = 0) out vec4 light;
layout(location = 0, index = 1) out vec4 through;

void main() {
  const Fragment f = shade();
  light = vec4(f.color + f.emission, 0.0);
  through = vec4(transmittance(f), 1.0);
}
