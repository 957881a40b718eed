// Phenomenological transparency, surface: inverse depth and motion of every fragment, each by its share of the fraction.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "surface/presence.glsl"
#include "surface/motion.glsl"
#include "methods/phenomenological/weight.glsl"
#include "methods/parts/weighted/seen.glsl"
#include "methods/parts/weighted/share.glsl"

layout(scalar, binding = 1) readonly buffer Cards { Card cards[]; };
layout(binding = 8) uniform sampler2D accum;
layout(binding = 9) uniform sampler2D modulation;
layout(location = 0) out vec4 surface;

void main() {
  const Fragment f = shade();
  const ivec2 pixel = ivec2(gl_FragCoord.xy);
  const float alpha = gray_coverage(f), covers = 1.0 - dot(texelFetch(modulation, pixel, 0).rgb, vec3(1.0 / 3.0));
  const float t = seen_share(weight(f.depth, alpha), texelFetch(accum, pixel, 0).a, covers, share_inside(vec3(alpha)).r);
  surface = surface_sample(presence(f) * t, f.depth, screen_motion(view, cards[f.id], gl_FragCoord.xy, f.depth));
}
