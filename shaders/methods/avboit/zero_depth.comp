// AVBOIT, zero-transmittance depth: for each tile of kTilePixels, the farthest depth over every cell that its pixels read at which
// nothing behind is seen any more; tiles that have one join a list that an indirect draw turns into quads.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "methods/avboit/zero_tile.h"
#include "shared/view.h"
#include "methods/avboit/depth_warp.glsl"

layout(local_size_x = 64) in;
layout(scalar, binding = 0) uniform View { ViewData view; };
layout(scalar, binding = 10) readonly buffer ZeroSlice { uint zero_slice[]; };
layout(scalar, binding = 11) buffer ZeroArguments { DrawCommand arguments; };
layout(scalar, binding = 12) writeonly buffer ZeroTiles { ZeroTile zero_tiles[]; };
layout(scalar, binding = 13) buffer ZeroDepths { float zero_depths[]; };   // reversed, a tile; 0: none
layout(push_constant) uniform Push { uvec2 tiles; };

void main() {
  const uint index = gl_GlobalInvocationID.x;
  if (index >= tiles.x * tiles.y) return;
  const uvec2 tile = uvec2(index % tiles.x, index / tiles.x);
  const ivec2 each = ivec2(kZeroTilePixels / volume.divisor), last = ivec2(volume.cells) - 1;
  const ivec2 low = max(ivec2(tile) * each - 1, ivec2(0)), high = min(ivec2(tile + 1u) * each, last);
  uint slice = 0u;
  for (int y = low.y; y <= high.y; ++y)
    for (int x = low.x; x <= high.x; ++x) slice = max(slice, zero_slice[uint(y) * volume.cells.x + uint(x)]);
  // The slice in which it ends is full only behind it; the guards are those whose fragments may read in front of that.
  const uint guarded = min(slice, kNoSlice - volume.zero_guard) + volume.zero_guard;
  zero_depths[index] = 0.0;
  if (guarded >= warp.used) return;
  const uint place = atomicAdd(arguments.instances, 1u);
  zero_depths[index] = view.near_m / slice_ends[guarded];
  zero_tiles[place] = ZeroTile(tile, zero_depths[index]);
}
