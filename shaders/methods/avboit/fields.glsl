// Extinction as integers: fields of kLaneBits bits, a slice each, packed into words in the order along the ray, so that a carry
// only touches what lies behind.
//   8 bits: e = tau / ln 255 (the talk; quantum 0.0217, thinner than half of it rounds to nothing);
//  16 bits: tau / 16 (quantum 0.00024);  32 bits: steps of 1/4096, overflowing at an optical depth of a million.
#ifndef PLUME_AVBOIT_FIELDS_GLSL
#define PLUME_AVBOIT_FIELDS_GLSL
#include "methods/avboit/volume.h"

uint full_field(uint bits) { return bits == 32u ? 0xffffffffu : (1u << bits) - 1u; }

float most_depth(uint bits) { return bits == 8u ? kLog255 : kMostDepth; }   // of one event

float steps_per_depth(uint bits) {
  return bits == 8u ? 255.0 / kLog255 : bits == 16u ? 65535.0 / kMostDepth : kStepsPerDepth32;
}

// Rounded to the nearest, or up with the probability of the fraction when `dither` is uniform in [0, 1) instead of 0.5.
uint quantise(float tau, uint bits, float dither) {
  return uint(min(tau, most_depth(bits)) * steps_per_depth(bits) + dither);
}
#endif
