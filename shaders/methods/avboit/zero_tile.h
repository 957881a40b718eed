// Tiles of the picture behind whose depth nothing is seen, and the indirect draw of them.
#ifndef PLUME_AVBOIT_ZERO_TILE_H
#define PLUME_AVBOIT_ZERO_TILE_H

#include "shared/draw_command.h"

PLUME_SHARED_BEGIN

const uint kZeroTilePixels =
    16u;  // each way: whole quads keep depth compression and hierarchical depth (the talk)

struct ZeroTile {
  uvec2 tile;
  float depth;  // reversed: near_m / view depth
};

PLUME_SHARED_END
#endif
