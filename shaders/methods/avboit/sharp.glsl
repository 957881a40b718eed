// Which cards are too sharp for the cells of the volume: those with hard edges, those of a few cells whose edges are seen, and those
// that a cell may miss. Their fragments go into the exact layers of their pixels instead.
#ifndef PLUME_AVBOIT_SHARP_GLSL
#define PLUME_AVBOIT_SHARP_GLSL
#include "effects/puff.h"
#include "methods/avboit/volume.h"
#include "shared/card.h"
#include "shared/view.h"

const float kThin = 0.05;        // optical depth below which an edge is not seen
const float kBare = 0.004;       // and below which a card that shines does not cover
const float kSeen = 0.3;         // from which the edge of a card of a few cells is
const float kMissed = 0.25;      // half extent, in cells, below which most samples of cells fall beside a card

bool is_sharp(Card card, ViewData view, Volume volume) {
  if (volume.exact_layers == 0u || card.optical_depth < kThin) return false;
  const uint layer = card.layers & ((1u << kLayerBits) - 1u);
  if (layer == kDiscLayer || layer == kSolidLayer) return true;
  const float pixels_per_metre = 0.5 * float(view.size.y) / (view.tan_half_fov.y * max(dot(card.center - view.camera, view.forward), view.near_m));
  const float smaller = min(length(card.axis_u), length(card.axis_v)) * pixels_per_metre;
  const float cells = smaller / float(volume.divisor);
  return cells < (card.optical_depth >= kSeen ? volume.small_cells : min(kMissed, volume.small_cells));
}

bool only_shines(Card card) { return card.emission != uvec2(0u) && card.optical_depth < kBare; }
#endif
