// Classes of cards by what has to be done with them: each is drawn with a shader that does no more.
#ifndef PLUME_AVBOIT_CARD_CLASS_H
#define PLUME_AVBOIT_CARD_CLASS_H

#include "shared/draw_command.h"

PLUME_SHARED_BEGIN

const uint kClasses = 16u;
const uint kClassUnseen = 12u;  // off the screen, dead, hidden, or without a part in these draws

// Where their extinction goes.
const uint kIntoScalar = 0u;  // the volume, one value
const uint kIntoRgb = 1u;     // the volume, a value a channel
const uint kIntoLayers = 2u;  // the exact layers of a pixel

// Their draw: 4 * kind, and a bit for each thing that may lie in front of them.
const uint kKindPlain = 0u;  // faces the camera, so it lies in one slice, and passes no light where it covers
const uint kKindGeneral = 1u;  // spans slices or passes light, all colours alike
const uint kKindRgb = 2u;      // passes some colours better than others
const uint kKindExact = 3u;    // is in the exact layers, or shines without covering
const uint kBehindRgb = 1u;
const uint kBehindLayers = 2u;  // always so for kKindExact

PLUME_SHARED_END
#endif
