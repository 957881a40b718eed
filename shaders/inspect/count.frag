// How many fragments a draw lets through, for each pixel of the picture. A fragment that stands for kScale x kScale pixels is shared
// out between them: the sum over the picture is the number of fragments, but for what lies beyond its edges.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "surface/shade.glsl"
#include "inspect/count.h"

layout(early_fragment_tests) in;
layout(constant_id = 10) const uint kScale = 1u;
layout(scalar, binding = 31) buffer Values { uint counts[]; };

void main() {
  if (density(puff_texel()) <= 0.0) discard;   // as shade() does
  for (uint y = 0u; y < kScale; ++y)
    for (uint x = 0u; x < kScale; ++x) {
      const uvec2 pixel = uvec2(gl_FragCoord.xy) * kScale + uvec2(x, y);
      if (all(lessThan(pixel, view.size))) atomicAdd(counts[pixel.y * view.size.x + pixel.x], kPartsOfAFragment / (kScale * kScale));
    }
}
