// AVBOIT, surface: inverse depth and motion of every fragment in any order, weighted by how much of it shows and by the transmittance
// T(z) in front of it.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "surface/presence.glsl"
#include "surface/motion.glsl"
#include "methods/avboit/sharp.glsl"
#include "methods/avboit/transmittance.glsl"

layout(scalar, binding = 1) readonly buffer Cards { Card cards[]; };
layout(location = 0) out vec4 surface;

void main() {
  const Fragment f = shade();
  const vec3 passed = f.id >= volume.rgb_first ? transmittance(f) : vec3(1.0 - gray_coverage(f));
  const vec3 own = -log(max(passed, vec3(kLeastTransmittance)));
  const bool sharp = is_sharp(cards[f.id], view, volume);
  bool estimated;
  const vec3 t = transmittance_at(gl_FragCoord.xy, slice_at(f.depth), sharp ? vec3(0.0) : own).transmittance *
                 layers_in_front(uvec2(gl_FragCoord.xy), f.depth, f.id, sharp ? tail_depth(pack_layer(transmittance(f))) : vec3(0.0), estimated);
  const float part = presence(f) * dot(t, vec3(1.0 / 3.0));
  surface = surface_sample(part, f.depth, screen_motion(view, cards[f.id], gl_FragCoord.xy, f.depth));
}
