// What each kBoundSpan of sorted cards can add to a pixel at most: (the brightest colour, since coverages share one ray; the sum of
// all that shines). Cards that no tile lists stand last: every bound holds for them too.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "methods/tile_sorted/tile_sorted.h"
#include "shared/card.h"
#include "shared/half.glsl"
#include "shared/workload.h"

layout(local_size_x = 64) in;
layout(scalar, binding = 1) readonly buffer Cards { Card cards[]; };
layout(scalar, binding = 8) readonly buffer Pairs { uvec2 pairs[]; };
layout(scalar, binding = 9) writeonly buffer Bounds { vec2 bounds[]; };
layout(scalar, binding = 7) readonly buffer Work { Workload work; };

const float kMostHeat = 1.8 * 1.8 * 1.8;   // of shade_texel()

float brightest(vec3 c) { return max(c.r, max(c.g, c.b)); }

void main() {
  const uint span = gl_GlobalInvocationID.x, first = span * kBoundSpan;
  if (first >= work.count) return;
  vec2 bound = vec2(0.0);
  for (uint rank = first; rank < min(first + kBoundSpan, work.count); ++rank) {
    const uint id = pairs[rank].y;
    const vec3 color = unpack_half4(cards[id].sunlit).rgb + unpack_half4(cards[id].ambient).rgb;
    bound.x = max(bound.x, brightest(color));
    bound.y += kMostHeat * brightest(unpack_half4(cards[id].emission).rgb);
  }
  bounds[span] = bound;
}
