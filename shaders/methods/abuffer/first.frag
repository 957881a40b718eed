// Bounded A-buffer as published: a pixel's counter hands out its layers, and the fragments that come when all are taken join the
// tail. Which those are depends on the order of draws.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "surface/pixel.glsl"
#include "surface/shade.glsl"
#include "methods/abuffer/layers.glsl"
#include "methods/parts/weighted/weighted.glsl"

layout(early_fragment_tests) in;

void main() {
  const Fragment f = shade();
  const vec3 t = kRgb != 0u ? transmittance(f) : vec3(1.0 - gray_coverage(f));
  const Stored stored = encode(f.color + f.emission, t, f.depth, f.id);
  if (changes_nothing(decode(stored))) discard;
  const uint pixel = pixel_index(view.size);
  const uint layer = atomicAdd(counters[pixel], 1u);
  if (layer < kLayers) {
    const uint place = layer * view.size.x * view.size.y + pixel;
    Words(bounded.keys).words[place] = stored.key;
    if (kRgb != 0u) Words(bounded.payloads).words[place] = stored.payload;
    discard;
  }
  write_weighted(f, vec3(1.0), vec3(1.0), kRgb != 0u);
}
