// Moments, depth warp: from the bounds of the cards, or from the camera's planes (kPlanes).
#version 460
#extension GL_GOOGLE_include_directive : require
#include "methods/moments/depth_warp.h"
#include "shared/view.h"

layout(local_size_x = 1) in;
layout(constant_id = 0) const uint kPlanes = 0u;
layout(scalar, binding = 0) uniform View { ViewData view; };
layout(scalar, binding = 8) readonly buffer Ends { DepthBounds bounds; };
layout(scalar, binding = 9) writeonly buffer Warp { DepthWarp warp; };

const float kMargin = 1.0 / 1024.0;   // relative: also keeps a single depth from having no range

void main() {
  vec2 ends = vec2(view.near_m, view.far_m);
  if (kPlanes == 0u && bounds.farthest != 0u) ends = uintBitsToFloat(uvec2(~bounds.not_nearest, bounds.farthest));
  const vec2 logs = log2(ends * vec2(1.0 - kMargin, 1.0 + kMargin));
  const float scale = 2.0 / (logs.y - logs.x);
  warp = DepthWarp(scale, -1.0 - logs.x * scale);
}
