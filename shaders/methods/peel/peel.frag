// Depth peeling, one peel: the fragment that is the pixel's current layer is blended, all behind it compete for the next,
//   light += L T,   T *= t                  from the front (Everitt 2001)
//   behind = L + t behind                   from the back, at the same time (Bavoil and Myers 2008)
// in 32 bits. Exactly one fragment of a pixel is the current layer of an end, so no two write one texel.
//
// The first peel has no current layer: it counts the fragments and finds the first. All peels are one pipeline, so that a fragment
// has the same depth in each.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_shader_atomic_int64 : require
#include "surface/shade.glsl"
#include "methods/peel/layers.glsl"

layout(early_fragment_tests) in;   // against the current layer: what has been peeled is not even shaded
layout(constant_id = 0) const uint kBothEnds = 0u;
layout(scalar, binding = 8) buffer Front { Layer front[]; };
layout(scalar, binding = 9) buffer Back { Layer back[]; };   // where kBothEnds
layout(scalar, binding = 10) buffer Depths { uint depths[]; };   // fragments of each pixel
layout(binding = 11, rgba32f) uniform image2D light;     // a: layers blended
layout(binding = 12, rgba32f) uniform image2D through;
layout(binding = 13, rgba32f) uniform image2D behind;    // where kBothEnds; a: layers blended

void main() {
  const ivec2 pixel = ivec2(gl_FragCoord.xy);
  if (gl_FragCoord.z < texelFetch(opaque_depth, pixel, 0).r) return;
  const uint ray = uint(pixel.y) * view.size.x + uint(pixel.x);
  const uint64_t key = key_of(v_uv_depth.z, v_layers_id.z), nearest = front[ray].now;
  const uint64_t farthest = kBothEnds != 0u ? back[ray].now : kFarthest;
  if (key < nearest || key > farthest) return;
  const Fragment f = shade();
  if (f.coverage == 0.0 && f.emission == vec3(0.0)) return;   // changes nothing, exactly
  if (nearest == kNearest) atomicAdd(depths[ray], 1u);
  if (key == nearest) {
    const vec4 passed = imageLoad(through, pixel);
    imageStore(light, pixel, imageLoad(light, pixel) + vec4((f.color + f.emission) * passed.rgb, 1.0));
    imageStore(through, pixel, vec4(passed.rgb * transmittance(f), 0.0));
  } else if (kBothEnds != 0u && key == farthest) {
    const vec4 there = imageLoad(behind, pixel);
    imageStore(behind, pixel, vec4(f.color + f.emission + there.rgb * transmittance(f), there.a + 1.0));
  } else {
    atomicMin(front[ray].next, key);
    if (kBothEnds != 0u) atomicMax(back[ray].next, key);
  }
}
