// Bounded A-buffer with a transmittance for each channel, first draw: which cards are the nearest.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "surface/pixel.glsl"
#include "surface/shade.glsl"
#include "methods/abuffer/nearest.glsl"

layout(early_fragment_tests) in;

void main() {
  const Fragment f = shade();
  const Stored stored = encode(f.color + f.emission, transmittance(f), f.depth, f.id);
  if (changes_nothing(decode(stored))) return;
  insert_nearest(pixel_index(view.size), view.size.x * view.size.y, stored.key);
}
