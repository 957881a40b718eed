// Wavelet transparency, the transmittance in front of a depth: read where fragments are drawn and where the probe asks.
#ifndef PLUME_WAVELETS_TRANSMITTANCE_GLSL
#define PLUME_WAVELETS_TRANSMITTANCE_GLSL
#include "methods/parts/absorbance/transmittance.glsl"
#include "methods/wavelets/haar.glsl"

vec3 absorbance_in_front(uvec2 cell, float depth, vec3 own) { return absorbance_at(cell, place_in(range_of(cell), depth), own); }

#endif
