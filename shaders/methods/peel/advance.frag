// Depth peeling, between two peels: the next layer becomes the current one, and its depth is written for the test that rejects what
// lies in front. A pixel that has no more layers gets a depth that rejects everything.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "methods/peel/layers.glsl"
#include "shared/view.h"

layout(constant_id = 0) const uint kBothEnds = 0u;
layout(scalar, binding = 0) uniform View { ViewData view; };
layout(scalar, binding = 8) buffer Front { Layer front[]; };
layout(scalar, binding = 9) buffer Back { Layer back[]; };
layout(binding = 11, rgba32f) writeonly uniform image2D light;
layout(binding = 12, rgba32f) writeonly uniform image2D through;
layout(binding = 13, rgba32f) writeonly uniform image2D behind;
layout(binding = 14) uniform sampler2D opaque_color;
layout(push_constant) uniform Push { uint peel; };

// The depth that is tested is rounded otherwise than the key's, and by more the steeper a triangle stands; it may only reject what lies in
// front. What is not rejected is shaded once more.
const float kDepthSlack = 1.0 + 1e-3;

void main() {
  const ivec2 pixel = ivec2(gl_FragCoord.xy);
  const uint ray = uint(pixel.y) * view.size.x + uint(pixel.x);
  if (peel == 0u) {
    front[ray] = Layer(kNearest, kFarthest);
    imageStore(light, pixel, vec4(0.0));
    imageStore(through, pixel, vec4(1.0));
    if (kBothEnds != 0u) {
      back[ray] = Layer(kFarthest, kNearest);
      imageStore(behind, pixel, vec4(texelFetch(opaque_color, pixel, 0).rgb, 0.0));
    }
    gl_FragDepth = 1.0;
    return;
  }
  const uint64_t next = front[ray].next;
  front[ray] = Layer(next, kFarthest);
  if (kBothEnds != 0u) back[ray] = Layer(back[ray].next, kNearest);
  gl_FragDepth = next == kFarthest ? 0.0 : min(view.near_m / depth_of(next) * kDepthSlack, 1.0);
}
