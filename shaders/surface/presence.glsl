// How much of a fragment shows: what a depth or a motion of the transparent image is weighted by. Coverage, and where something glows
// without covering, how bright the glow is as exposed: a lamp in thin smoke shows more than the smoke does.
#ifndef PLUME_SURFACE_PRESENCE_GLSL
#define PLUME_SURFACE_PRESENCE_GLSL
#include "surface/shade.glsl"

const float kMostPresence = 64.0;   // half floats sum a few hundred of them

float presence(Fragment f) {
  const float glow = view.exposure * dot(f.emission, vec3(0.2126, 0.7152, 0.0722));
  return max(gray_coverage(f), min(glow, kMostPresence));
}

#endif
