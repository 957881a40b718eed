// AVBOIT's extinction volume: camera-aligned cells at a fraction of the picture's resolution, slices on a
// logarithmic depth curve. Drobot, "Adaptive Voxel-Based Order Independent Transparency", SIGGRAPH 2025
// Advances in Real-Time Rendering.
#ifndef PLUME_AVBOIT_VOLUME_H
#define PLUME_AVBOIT_VOLUME_H

#include "shared/types.h"

PLUME_SHARED_BEGIN

struct Volume {
  uvec2 cells;    // of the picture, rounded up
  uint divisor;   // pixels a cell, each way
  uint slices;    // n, a multiple of 4
  float curve_a;  // m; linear below, logarithmic beyond
  float curve_b;  // m; depth of the last slice
  float bias;     // slices in front of a fragment at which the integral is read
  float padding;
};

const float kLog255 = 5.5412635f;           // ln 255: the optical depth of one full 8-bit field
const float kLeastTransmittance = 1.1e-7f;  // e^-16: black in every format, and a logarithm exists
const uint kNoOverflow = 0xffffffffu;

PLUME_SHARED_END
#endif
