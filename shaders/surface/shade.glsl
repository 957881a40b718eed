// shade() in fragment shaders: the varyings come from surface/card.glsl.
#ifndef PLUME_SURFACE_SHADE_GLSL
#define PLUME_SURFACE_SHADE_GLSL

layout(location = 0) in vec3 v_uv_depth;
layout(location = 1) flat in vec4 v_sunlit;
layout(location = 2) flat in vec4 v_ambient;
layout(location = 3) flat in vec4 v_emission;
layout(location = 4) flat in vec4 v_transmission;
layout(location = 5) flat in vec3 v_light;
layout(location = 6) flat in uvec3 v_layers_id;

float opaque_here();   // near_m / view depth of the opaque surface; 0 = sky

#include "surface/shading.glsl"

float opaque_here() { return texelFetch(opaque_depth, ivec2(gl_FragCoord.xy), 0).r; }

Fragment shade() {
  const vec4 texel = puff_texel();
  const float density_here = density(texel);
  if (density_here <= 0.0) discard;   // the corners of a puff: nothing is left to do
  return shade_texel(texel, density_here);
}

#endif
