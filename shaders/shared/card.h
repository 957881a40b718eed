// A card: what every transparent thing is drawn as. A parallelogram in the world with a texture of optical
// depth on it: a camera-facing sprite, a pane of glass, a painted quad. Or the half of one: a triangle of a
// mesh or of a ribbon, with corners (-1, -1), (1, -1) and (-1, 1) along the axes. Two halves with opposite
// axes share their centre and are the whole.
#ifndef PLUME_SHARED_CARD_H
#define PLUME_SHARED_CARD_H

#include "shared/types.h"

PLUME_SHARED_BEGIN

struct Card {
  vec3 center;          // world, m; camera offset applied
  float optical_depth;  // of the texture's mean; 0 = not drawn
  vec3 axis_u;          // half edges, m
  float inv_feather;    // 1/m, z-feather in front of opaque surfaces; 0 = none
  vec3 axis_v;
  uint layers;  // two texture layers, 12 bits each, then flags: kCard...
  // Colours are four half floats in two words: see pack_half4.
  uvec2 sunlit;        // rgb radiance when fully lit by the sun; a: blend between the two layers
  uvec2 ambient;       // rgb radiance from everywhere; a: unused
  uvec2 emission;      // rgb radiance added, whatever the coverage; a: unused
  uvec2 transmission;  // rgb share of light that passes where covered; a: diffusion, radians
  uvec2 light;         // xyz direction to the sun in the card's frame (u, v, towards the camera); a: unused
  uvec2 motion;        // xyz metres a tick; a: distortion, radians at the mean density and full slope
};

const uint kLayerBits = 12u;
const uint kCardSetApart = 1u << 24u;  // of a named layer: its slices are set apart from those around it
const uint kCardTriangle = 1u << 25u;  // the half of the parallelogram where u + v <= 0

#ifdef __cplusplus
inline
#endif
    bool
    is_triangle(Card card) {
  return (card.layers & kCardTriangle) != 0u;
}

PLUME_SHARED_END
#endif
