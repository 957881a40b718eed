// Which pixel a fragment belongs to, of size.x * size.y. Fragments beyond the picture's border, which are run as members of a quad, get one
// inside: what shaders read by address is not held to its buffer.
#ifndef PLUME_SURFACE_PIXEL_GLSL
#define PLUME_SURFACE_PIXEL_GLSL

uint pixel_index(uvec2 size) {
  const uvec2 at = min(uvec2(gl_FragCoord.xy), size - 1u);
  return at.y * size.x + at.x;
}

#endif
