// Which cards are too sharp for the cells of the volume: those with hard edges, and near-opaque ones about as small as a cell.
// Their fragments go into the exact layers of their pixels instead.
#ifndef PLUME_AVBOIT_SHARP_GLSL
#define PLUME_AVBOIT_SHARP_GLSL
#include "effects/puff.h"
#include "methods/avboit/volume.h"
#include "shared/card.h"
#include "shared/view.h"

const float kThin = 0.05;        // optical depth below which an edge is not seen
const float kBare = 0.004;       // and below which a card that shines does not cover
const float kNearOpaque = 0.7;   // coverage of a half
const float kSmallCells = 1.5;   // half extent

bool is_sharp(Card card, ViewData view, Volume volume) {
  if (volume.exact_layers == 0u || card.optical_depth < kThin) return false;
  const uint layer = card.layers & ((1u << kLayerBits) - 1u);
  if (layer == kDiscLayer || layer == kSolidLayer) return true;
  const float pixels_per_metre = 0.5 * float(view.size.y) / (view.tan_half_fov.y * max(dot(card.center - view.camera, view.forward), view.near_m));
  const float smaller = min(length(card.axis_u), length(card.axis_v)) * pixels_per_metre;
  return card.optical_depth >= kNearOpaque && smaller < kSmallCells * float(volume.divisor);
}

bool only_shines(Card card) { return card.emission != uvec2(0u) && card.optical_depth < kBare; }
#endif
