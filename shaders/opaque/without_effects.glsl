// Light on opaque things where no effect takes or gives any.
#ifndef PLUME_OPAQUE_WITHOUT_EFFECTS_GLSL
#define PLUME_OPAQUE_WITHOUT_EFFECTS_GLSL
#include "opaque/lighting.glsl"

Reached reached(vec3 world, vec3 normal) { return Reached(1.0, 1.0, vec3(0.0)); }

#endif
