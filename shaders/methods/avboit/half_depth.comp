// The farthest opaque depth of 2 x 2 pixels: what half-resolution particles are feathered against, and what their pixels are told
// apart by when they are put beside full-resolution things.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "surface/low_resolution.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 8) uniform sampler2D opaque_depth;
layout(binding = 9, r32f) writeonly uniform image2D half_opaque;
layout(push_constant) uniform Push { uvec2 size; };

void main() {
  const ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(uvec2(at), size))) return;
  imageStore(half_opaque, at, vec4(farthest_depth(opaque_depth, at, 2)));
}
