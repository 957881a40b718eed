// What the passes of tile-sorted compute hand to each other.
#ifndef PLUME_METHODS_TILE_SORTED_H
#define PLUME_METHODS_TILE_SORTED_H

#include "shared/types.h"

PLUME_SHARED_BEGIN

const uint kNotInTiles = 0xffffffffu;  // sort key of cards that no tile lists; those that it does are nearer
const uint kBoundSpan = 256u;          // cards that share one bound of what lies behind
const uint kWalkSquare = 16u;          // pixels, each way, of one work group
const uint kMaskSpan = 32u;            // words of a tile's mask that one thread counts

// A card that faces the camera, on the screen: uv = pixel_to_uv (pixel - center), 1 at its edges. Whole
// vec4s, which devices load at once; colours as set_varyings() would unpack them.
struct TileCard {
  vec4 pixel_to_uv;   // row by row
  vec4 place;         // centre in pixels, view depth in metres, most radiance of this and all behind it
  vec4 sunlit;        // a: blend between the two layers
  vec4 ambient;       // a: optical depth
  vec4 emission;      // a: 1 / feather
  vec4 transmission;  // a: the bits of Card::layers
  vec4 light;         // a: the bits of the card's index
};

struct TileTotals {
  uint cards;           // in tiles
  uint tilted;          // not facing the camera: captured pixel by pixel
  uint entries;         // of all tiles' lists: beyond `capacity` they were counted, not stored
  uint capacity;        // of `entries`
  uvec2 address;        // of uint[capacity]: lists outgrow the range of a descriptor
  uint stopped_pixels;  // which nothing behind could change any more
};

// Squares of the walk, in two lists of `number` places each: those without and those with fragments of tilted
// cards. A word is x | y << 16.
struct WalkSquares {
  uint groups[2][3];  // VkDispatchIndirectCommand of each list
  uint number;
};

struct TileGrid {
  uvec2 tiles;
  uint cards;
  uint words;  // of a tile's mask: a bit a card
  uint spans;  // of kMaskSpan words
};

PLUME_SHARED_END
#endif
