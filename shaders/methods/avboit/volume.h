// AVBOIT's extinction volume: camera-aligned cells at a fraction of the picture's resolution; along each ray,
// physical slices that hold the occupied ones of many virtual slices. Drobot, "Adaptive Voxel-Based Order
// Independent Transparency", SIGGRAPH 2025 Advances in Real-Time Rendering.
#ifndef PLUME_AVBOIT_VOLUME_H
#define PLUME_AVBOIT_VOLUME_H

#include "shared/types.h"

PLUME_SHARED_BEGIN

const uint kMostSlices = 256u;              // physical, along a ray
const uint kMostVirtualSlices = 32768u;     // where adaptation starts at the finest
const uint kLeastVirtualSlices = 32u;       // and where it ends: they always fit
const uint kTileCells = 8u;                 // of an occupancy tile, each way
const uint kMaskWords = kMostSlices / 32u;  // one bit a slice
const uint kApartWidth = 8u;                // physical slices of a virtual one that is set apart

struct Volume {
  uvec2 cells;          // of the picture, rounded up
  uvec2 tiles;          // of kTileCells x kTileCells cells
  uint divisor;         // pixels a cell, each way
  uint slices;          // physical: the budget
  uint virtual_slices;  // at the finest: a power of two
  uint fixed_slices;    // 1: `slices` virtual slices, all of them physical, whatever is occupied (VBOIT)
  float curve_a;        // m; linear below, logarithmic beyond
  float curve_octaves;  // log2(1 + b / a)
  float bias;           // slices in front of a fragment at which biased samplings read
  uint guard_before;    // slices kept in front of an occupied range for what reads there
  uint guard_after;     // and behind it
  float zero_depth;     // optical depth from which nothing behind is seen
  uint zero_guard;      // slices behind it that are still drawn: those that may read in front of it
  uint rgb_first;       // index of the first card whose extinction is kept for each channel
  uint cards;
  uint exact_layers;  // of a pixel, for sharp cards
  float small_cells;  // half extent, in cells, below which a card is one of them
};

// What adaptation chose; a table of nodes follows it in the buffer.
struct DepthWarp {
  uint virtual_slices;  // n
  uint used;            // physical slices
  float scale;          // n / log2(1 + b / a)
  uint apart_dropped;   // 1: slices set apart did not fit and were not
};

const float kLeastTransmittance = 1.1e-7f;  // e^-16: black in every format, and a logarithm exists
const float kMostDepth = 16.0f;             // optical depth of a full 16-bit field
const float kFullSlice =
    8.0f;  // what one slice counts at most: nothing is seen behind it, and what shares it still is
const float kSaturatedDepth = 64.0f;     // stands for T = 0 in the integral
const float kLog255 = 5.5412635f;        // ln 255: the optical depth of a full 8-bit field
const float kStepsPerDepth32 = 4096.0f;  // of a 32-bit word, a unit of optical depth
const uint kNoOverflow = 0xffffffffu;
const uint kNoSlice = 0xffffffffu;

PLUME_SHARED_END
#endif
