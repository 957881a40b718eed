// Which pixel a fragment belongs to, of size.x * size.y.
#ifndef PLUME_SURFACE_PIXEL_GLSL
#define PLUME_SURFACE_PIXEL_GLSL
#include "surface/inside.glsl"

uint pixel_index(uvec2 size) { return index_inside(uvec2(gl_FragCoord.xy), size); }

#endif
