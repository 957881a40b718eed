// Bounded A-buffer with a transmittance for each channel, second draw: a card that is among the nearest stores what it is, any
// other joins the tail.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "surface/pixel.glsl"
#include "surface/shade.glsl"
#include "methods/abuffer/layers.glsl"
#include "methods/parts/weighted/weighted.glsl"

layout(early_fragment_tests) in;

void main() {
  const Fragment f = shade();
  const Stored stored = encode(f.color + f.emission, transmittance(f), f.depth, f.id);
  if (changes_nothing(decode(stored))) discard;
  const uint pixels = view.size.x * view.size.y, pixel = pixel_index(view.size);
  Words keys = Words(bounded.keys);
  if (stored.key.y <= keys.words[(kLayers - 1u) * pixels + pixel].y)
    for (uint k = 0u; k < kLayers; ++k)
      if (keys.words[k * pixels + pixel].x == f.id) {   // a card has one fragment a pixel
        Words(bounded.payloads).words[k * pixels + pixel] = stored.payload;
        discard;
      }
  atomicAdd(counters[pixel], 1u);
  write_weighted(f, vec3(1.0), vec3(1.0), true);
}
