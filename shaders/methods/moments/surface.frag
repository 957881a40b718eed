// Moments, surface: inverse depth and motion of every fragment in any order, weighted by how much of it shows and by the transmittance in
// front of it; of what covers, in the fraction that resolve makes of the colours.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "surface/presence.glsl"
#include "surface/motion.glsl"
#include "methods/moments/transmittance.glsl"

layout(scalar, binding = 1) readonly buffer Cards { Card cards[]; };
layout(binding = 16) uniform sampler2D through;   // of the draw: methods/parts/weighted/weighted.glsl
layout(binding = 17) uniform sampler2D norm;      // `norm` where each channel has one, else `accum`
layout(location = 0) out vec4 surface;

void main() {
  const Fragment f = shade();
  bool unsure;
  const vec3 t = transmittance_at(ivec2(gl_FragCoord.xy), f.depth, unsure);
  const vec4 passed = texelFetch(through, ivec2(gl_FragCoord.xy), 0), weights = texelFetch(norm, ivec2(gl_FragCoord.xy), 0);
  const vec3 covered = 1.0 - (kRgb != 0u ? passed.rgb : passed.rrr);
  const vec3 fraction = t * kWeightScale * covered / max(kRgb != 0u ? weights.rgb : weights.aaa, vec3(1e-5));
  const float coverage = gray_coverage(f);
  const float part = coverage * dot(fraction, vec3(1.0 / 3.0)) + (presence(f) - coverage) * dot(t, vec3(1.0 / 3.0));
  surface = surface_sample(part, f.depth, screen_motion(view, cards[f.id], gl_FragCoord.xy, f.depth));
}
