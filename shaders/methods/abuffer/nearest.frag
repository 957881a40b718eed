// Bounded A-buffer, one transmittance: a layer is one word, so one draw keeps the nearest. What is pushed out joins the tail as it
// was stored, whoever pushed it.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "surface/pixel.glsl"
#include "surface/shade.glsl"
#include "methods/abuffer/nearest.glsl"
#include "methods/parts/weighted/weighted.glsl"

layout(early_fragment_tests) in;

void main() {
  const Fragment f = shade();
  const Stored stored = encode(f.color + f.emission, vec3(1.0 - gray_coverage(f)), f.depth, f.id);
  if (changes_nothing(decode(stored))) discard;
  const uint pixel = pixel_index(view.size);
  const uvec2 out_key = insert_nearest(pixel, view.size.x * view.size.y, stored.key);
  if (is_free(out_key)) discard;
  atomicAdd(counters[pixel], 1u);
  const Layer pushed = decode(Stored(out_key, uvec2(0u)));
  // Light is taken as emission: what little of it is uncovered must not enter the average.
  Fragment out_fragment = f;
  out_fragment.color = vec3(0.0);
  out_fragment.emission = pushed.light;
  out_fragment.coverage = 1.0 - pushed.transmittance.g;
  out_fragment.transmission = vec3(0.0);
  write_weighted(out_fragment, vec3(1.0), vec3(1.0), false);
}
