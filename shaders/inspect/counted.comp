// From parts of fragments, counted by count.frag, to numbers of fragments.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "inspect/count.h"
#include "inspect/inspect.glsl"

bool inspect(uvec2 pixel, out float value) {
  const uint parts = values[pixel.y * look.size.x + pixel.x];
  value = float(parts) / float(kPartsOfAFragment);
  return parts > 0u;
}
