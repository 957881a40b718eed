// Sorted cards onto the screen: each becomes a TileCard at its rank and sets its bit in the mask of every tile that it touches. Bits
// know their places, so that masks come out sorted whatever the order of writing.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "methods/tile_sorted/touches.glsl"
#include "shared/card.h"
#include "shared/half.glsl"
#include "shared/view.h"
#include "shared/workload.h"

layout(local_size_x = kItemGroup) in;
layout(constant_id = 0) const uint kTile = 16u;   // pixels
layout(scalar, binding = 0) uniform View { ViewData view; };
layout(scalar, binding = 1) readonly buffer Cards { Card cards[]; };
layout(scalar, binding = 7) readonly buffer Work { Workload work; };
layout(scalar, binding = 8) readonly buffer Pairs { uvec2 pairs[]; };
layout(scalar, binding = 9) readonly buffer Bounds { vec2 bounds[]; };
layout(scalar, binding = 10) writeonly buffer TileCards { TileCard tile_cards[]; };
layout(scalar, binding = 11) buffer Masks { uint masks[]; };
layout(push_constant, scalar) uniform Push { TileGrid grid; };

vec2 on_screen(vec3 axis) { return vec2(dot(axis, view.right), -dot(axis, view.up)); }

void main() {
  const uint rank = gl_GlobalInvocationID.x;
  if (rank >= work.count || pairs[rank].x == kNotInTiles) return;
  const uint id = pairs[rank].y;
  const Card card = cards[id];
  const float depth = uintBitsToFloat(pairs[rank].x);
  const vec2 pixels_a_metre = 0.5 * vec2(view.size) / (view.tan_half_fov * depth);
  const vec2 u = on_screen(card.axis_u) * pixels_a_metre, v = on_screen(card.axis_v) * pixels_a_metre;
  const float area = u.x * v.y - u.y * v.x;
  if (area == 0.0) return;   // seen edge on, or too small for a float
  const vec2 behind = bounds[rank / kBoundSpan];

  TileCard placed;
  placed.pixel_to_uv = vec4(v.y, -v.x, -u.y, u.x) / area;
  const vec2 center = 0.5 * vec2(view.size) + on_screen(card.center - view.camera) * pixels_a_metre;
  placed.place = vec4(center, depth, behind.x + behind.y);
  placed.sunlit = unpack_half4(card.sunlit);
  placed.ambient = vec4(unpack_half4(card.ambient).rgb, card.optical_depth);
  placed.emission = vec4(unpack_half4(card.emission).rgb, card.inv_feather);
  placed.transmission = vec4(unpack_half4(card.transmission).rgb, uintBitsToFloat(card.layers));
  placed.light = vec4(unpack_half4(card.light).xyz, uintBitsToFloat(id));
  tile_cards[rank] = placed;

  const vec2 reach = abs(u) + abs(v), last = vec2(grid.tiles) - 1.0;
  const uvec2 low = uvec2(clamp((center - reach) / float(kTile), vec2(0.0), last));
  const uvec2 high = uvec2(clamp((center + reach) / float(kTile), vec2(0.0), last));
  const uint word = rank / 32u, bit = 1u << (rank % 32u);
  for (uint y = low.y; y <= high.y; ++y)
    for (uint x = low.x; x <= high.x; ++x)
      if (touches(placed.pixel_to_uv, center, (vec2(x, y) + 0.5) * float(kTile), vec2(0.5 * float(kTile))))
        atomicOr(masks[(y * grid.tiles.x + x) * grid.words + word], bit);
}
