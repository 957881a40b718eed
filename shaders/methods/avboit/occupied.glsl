// Which slices of a tile are occupied: what clear and integrate skip, and where nothing is written nothing is read.
#ifndef PLUME_AVBOIT_OCCUPIED_GLSL
#define PLUME_AVBOIT_OCCUPIED_GLSL
#include "methods/avboit/volume.h"

layout(constant_id = 0) const uint kSparse = 1u;   // 0: every slice counts as occupied
layout(scalar, binding = 8) uniform VolumeBlock { Volume volume; };
layout(scalar, binding = 10) readonly buffer Occupancy { uint occupancy[]; };   // [scalar, rgb][tile][kMaskWords]

uint tile_index() { return gl_WorkGroupID.y * volume.tiles.x + gl_WorkGroupID.x; }

uint scalar_mask(uint tile, uint word) { return kSparse == 0u ? 0xffffffffu : occupancy[tile * kMaskWords + word]; }
uint rgb_mask(uint tile, uint word) {
  return kSparse == 0u ? 0xffffffffu : occupancy[(volume.tiles.x * volume.tiles.y + tile) * kMaskWords + word];
}
#endif
