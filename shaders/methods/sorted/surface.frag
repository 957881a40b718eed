// Inverse depth and motion of sorted cards, back to front:  sum = what shows of it + t * what is behind.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "surface/presence.glsl"
#include "surface/motion.glsl"

layout(scalar, binding = 1) readonly buffer Cards { Card cards[]; };
layout(location = 0, index = 0) out vec4 surface;
layout(location = 0, index = 1) out vec4 through;

void main() {
  const Fragment f = shade();
  surface = surface_sample(presence(f), f.depth, screen_motion(view, cards[f.id], gl_FragCoord.xy, f.depth));
  through = vec4(1.0 - gray_coverage(f));
}
