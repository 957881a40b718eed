// Bounded A-buffer, resolve: the layers of a pixel, sorted by their keys, over the background with the tail on it,
//   image = sum_i L_i prod_{j<i} t_j  +  background prod_i t_i,
// and a count of what found no layer.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "methods/abuffer/layers.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = 3) const uint kNearest = 1u;   // layers lie front to back, and counters count what overflowed
layout(binding = 10, rgba16f) uniform image2D result;   // holds the background
layout(push_constant) uniform Push { uvec2 size; };

shared uint s_fragments, s_pixels;

bool in_front(uvec2 a, uvec2 b) { return a.y < b.y || (a.y == b.y && a.x < b.x); }

void composite(uvec2 pixel) {
  const uint pixels = size.x * size.y, ray = pixel.y * size.x + pixel.x, count = counters[ray];
  Stored layers[kLayers];
  uint used = 0u;
  for (uint k = 0u; k < kLayers; ++k) {
    if (kNearest == 0u && k >= count) break;
    const Stored layer = read_layer(k * pixels + ray);
    if (kNearest != 0u && is_free(layer.key)) break;
    uint at = used++;
    if (kNearest == 0u)
      for (; at > 0u && in_front(layer.key, layers[at - 1u].key); --at) layers[at] = layers[at - 1u];
    layers[at] = layer;
  }
  vec3 light = vec3(0.0), through = vec3(1.0);
  for (uint k = 0u; k < used; ++k) {
    const Layer layer = decode(layers[k]);
    light += layer.light * through;
    through *= layer.transmittance;
  }
  if (used > 0u) imageStore(result, ivec2(pixel), vec4(light + imageLoad(result, ivec2(pixel)).rgb * through, 1.0));
  const uint overflowed = kNearest != 0u ? count : count - min(count, kLayers);
  if (overflowed > 0u) {
    atomicAdd(s_fragments, overflowed);
    atomicAdd(s_pixels, 1u);
  }
}

void main() {
  const bool first = gl_LocalInvocationIndex == 0u;
  if (first) s_fragments = s_pixels = 0u;
  barrier();
  const uvec2 pixel = gl_GlobalInvocationID.xy;
  if (all(lessThan(pixel, size))) composite(pixel);
  barrier();
  if (first && s_pixels > 0u) {
    atomicAdd(bounded.overflowed_fragments, s_fragments);
    atomicAdd(bounded.overflowed_pixels, s_pixels);
  }
}
