// The array of card textures: puffs in variants and flipbook frames, then a disc, a soft dot, a solid square
// and a band, soft across v and the same all along u.
#ifndef PLUME_EFFECTS_PUFF_H
#define PLUME_EFFECTS_PUFF_H

#include "shared/types.h"

PLUME_SHARED_BEGIN

const uint kPuffSize = 96u;  // texels, each way
const uint kPuffVariants = 3u;
const uint kPuffFrames = 12u;  // a loop
const uint kDiscLayer = kPuffVariants * kPuffFrames;
const uint kSoftLayer = kDiscLayer + 1u;
const uint kSolidLayer = kDiscLayer + 2u;
const uint kBandLayer = kDiscLayer + 3u;
const uint kPuffLayers = kDiscLayer + 4u;

const float kMeanOpenness = 0.8f;  // of puffs: 1 on hills, less in creases

const uint kTexturePuff = 0u;  // TextureKind
const uint kTextureDisc = 1u;
const uint kTextureSoft = 2u;
const uint kTextureSolid = 3u;
const float kOpaqueDepth = 64.0f;  // optical depth that stands for alpha = 1: e^-64 is 0 beside 1 in 32 bits

PLUME_SHARED_END
#endif
