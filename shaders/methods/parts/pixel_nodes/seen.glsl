// Fragments that change the picture, and the pixel they belong to.
#ifndef PLUME_PIXEL_NODES_SEEN_GLSL
#define PLUME_PIXEL_NODES_SEEN_GLSL
#include "surface/pixel.glsl"

layout(early_fragment_tests) in;

// Without `discard`, so that what follows is reached by all.
bool shade_seen(out Fragment f) {
  const vec4 texel = puff_texel();
  const float density_here = density(texel);
  f = shade_texel(texel, max(density_here, 0.0));
  return density_here > 0.0 && (f.coverage > 0.0 || f.emission != vec3(0.0));
}

#endif
