// Fragments that change the picture, and the pixel they belong to.
#ifndef PLUME_PIXEL_NODES_SEEN_GLSL
#define PLUME_PIXEL_NODES_SEEN_GLSL

layout(early_fragment_tests) in;

uint pixel_index() { return uint(gl_FragCoord.y) * view.size.x + uint(gl_FragCoord.x); }

// Without `discard`, so that what follows is reached by all.
bool shade_seen(out Fragment f) {
  const vec4 texel = puff_texel();
  const float density_here = density(texel);
  f = shade_texel(texel, max(density_here, 0.0));
  return density_here > 0.0 && (f.coverage > 0.0 || f.emission != vec3(0.0));
}

#endif
