// How much of a fragment shows: what a depth or a motion of the transparent image is weighted by. Coverage, and where something glows
// without covering, how bright the glow is as exposed: 1 - 1 / (1 + exposure * luminance).
#ifndef PLUME_SURFACE_PRESENCE_GLSL
#define PLUME_SURFACE_PRESENCE_GLSL
#include "surface/shade.glsl"

float presence(Fragment f) {
  const float glow = view.exposure * dot(f.emission, vec3(0.2126, 0.7152, 0.0722));
  return max(gray_coverage(f), glow / (1.0 + glow));
}

#endif
