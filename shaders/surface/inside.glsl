// Where what is kept for each of size.x * size.y cells is, by its index. Fragments beyond the picture's border, which are run as members of a
// quad, get a cell inside: what shaders read by address is not held to its buffer.
#ifndef PLUME_SURFACE_INSIDE_GLSL
#define PLUME_SURFACE_INSIDE_GLSL

uint index_inside(uvec2 at, uvec2 size) {
  const uvec2 inside = min(at, size - 1u);
  return inside.y * size.x + inside.x;
}

#endif
