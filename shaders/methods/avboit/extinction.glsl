// The optical depth that the splat left in a slice of a cell, from fields, words or layers; occupied slices only.
#ifndef PLUME_AVBOIT_EXTINCTION_GLSL
#define PLUME_AVBOIT_EXTINCTION_GLSL
#include "methods/avboit/fields.glsl"
#include "methods/avboit/occupied.glsl"

layout(constant_id = 1) const uint kLaneBits = 16u;
layout(constant_id = 2) const uint kRgbWords = 3u;   // of extinction a slice: 0 in layers, 1 packed, 3 apart
layout(constant_id = 5) const uint kRaster = 0u;     // scalar extinction is in layers, as transmittance
layout(scalar, binding = 11) readonly buffer Extinction { uint extinction[]; };
layout(scalar, binding = 14) readonly buffer ExtinctionRgb { uint extinction_rgb[]; };
layout(binding = 20) uniform sampler2DArray extinction_layers;
layout(binding = 21) uniform sampler2DArray extinction_layers_rgb;

float depth_left(float through) { return through > 0.0 ? -log(through) : kSaturatedDepth; }

float scalar_depth(ivec2 cell, uint ray, uint slice) {
  if (kRaster != 0u) return depth_left(texelFetch(extinction_layers, ivec3(cell, slice), 0).r);
  const uint lanes = 32u / kLaneBits;
  const uint word = extinction[ray * (volume.slices / lanes) + slice / lanes];
  return float((word >> (kLaneBits * (slice % lanes))) & full_field(kLaneBits)) / steps_per_depth(kLaneBits);
}

vec3 rgb_depth(ivec2 cell, uint ray, uint slice) {
  if (kRgbWords == 0u) {
    const vec3 through = texelFetch(extinction_layers_rgb, ivec3(cell, slice), 0).rgb;
    return vec3(depth_left(through.r), depth_left(through.g), depth_left(through.b));
  }
  if (kRgbWords == 1u) {
    const uint word = extinction_rgb[ray * volume.slices + slice];
    return vec3(uvec3(word, word >> 10, word >> 20) & 1023u) / steps_per_depth(8u);
  }
  const uint first = (ray * volume.slices + slice) * 3u;
  return vec3(extinction_rgb[first], extinction_rgb[first + 1u], extinction_rgb[first + 2u]) / steps_per_depth(32u);
}

#endif
