// Haze joins the pixels' lists like everything else: it passes all light and gives none, and its shift is kept beside its node.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "surface/haze.glsl"
#include "methods/parts/fragment_list/append.glsl"

void main() {
  const vec2 shift = haze_shift();
  if (shift == vec2(0.0)) return;
  const uint slot = append(FragmentNode(vec3(0.0), v_uv_depth.z, vec3(1.0), v_layers_id.z, kListEnd));
  if (slot < pool.capacity) Extras(pool.extras).extras[slot] = shift;
}
