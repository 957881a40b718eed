// shade() in compute shaders: whoever includes this sets what a draw would interpolate, and the opaque surface's depth.
#ifndef PLUME_SURFACE_SHADE_AT_GLSL
#define PLUME_SURFACE_SHADE_AT_GLSL

vec3 v_uv_depth;
vec4 v_sunlit, v_ambient, v_emission, v_transmission;
vec3 v_light;
uvec3 v_layers_id;
float v_opaque;   // near_m / view depth; 0 = sky

float opaque_here() { return v_opaque; }

#include "surface/shading.glsl"

// False where shade() would discard: nothing is left to do.
bool shade_at(out Fragment fragment) {
  const vec4 texel = puff_texel();
  const float density_here = density(texel);
  fragment = shade_texel(texel, density_here);
  return density_here > 0.0;
}

#endif
