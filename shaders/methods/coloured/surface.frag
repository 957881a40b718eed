// Coloured weighted blending, surface: inverse depth and motion of every fragment, each by its share of the fraction.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "surface/presence.glsl"
#include "surface/motion.glsl"
#include "methods/coloured/sums.glsl"
#include "methods/coloured/weight.glsl"
#include "methods/parts/weighted/seen.glsl"
#include "methods/parts/weighted/share.glsl"

layout(scalar, binding = 1) readonly buffer Cards { Card cards[]; };
layout(location = 0) out vec4 surface;

void main() {
  const Fragment f = shade();
  const float alpha = gray_coverage(f);
  const Sums s = sums_at(ivec2(gl_FragCoord.xy));
  const float t = seen_share(weight(f.depth, alpha), s.accum.a, 1.0 - s.through.r, share_inside(vec3(alpha)).r);
  surface = surface_sample(presence(f) * t, f.depth, screen_motion(view, cards[f.id], gl_FragCoord.xy, f.depth));
}
