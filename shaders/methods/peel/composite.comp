// Depth peeling, the composite: what was peeled from the front over what was peeled from the back, or over the background. Layers
// that were counted and never blended are told.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "methods/peel/peel.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = 0) const uint kBothEnds = 0u;
layout(scalar, binding = 8) buffer Counts { PeelCounts counts; };
layout(scalar, binding = 10) readonly buffer Depths { uint depths[]; };
layout(binding = 11, rgba32f) readonly uniform image2D light;
layout(binding = 12, rgba32f) readonly uniform image2D through;
layout(binding = 13, rgba32f) readonly uniform image2D behind;
layout(binding = 14) uniform sampler2D opaque_color;
layout(binding = 15, rgba16f) writeonly uniform image2D result;
layout(push_constant) uniform Push {
  uvec2 size;
  uint most;   // layers that may be peeled
};

void main() {
  const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(uvec2(pixel), size))) return;
  const vec4 front = imageLoad(light, pixel);
  const vec4 back = kBothEnds != 0u ? imageLoad(behind, pixel) : vec4(texelFetch(opaque_color, pixel, 0).rgb, 0.0);
  imageStore(result, pixel, vec4(front.rgb + imageLoad(through, pixel).rgb * back.rgb, 1.0));
  const uint blended = uint(front.a + back.a), expected = min(depths[uint(pixel.y) * size.x + uint(pixel.x)], most);
  if (blended != expected) atomicAdd(counts.missed, expected - blended);
}
