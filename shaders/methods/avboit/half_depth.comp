// The farthest opaque depth of 2 x 2 pixels (reversed depth: the least): what half-resolution particles are feathered against, and
// what their pixels are told apart by when they are put beside full-resolution things.
#version 460
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 8) uniform sampler2D opaque_depth;
layout(binding = 9, r32f) writeonly uniform image2D half_opaque;
layout(push_constant) uniform Push { uvec2 size; };

void main() {
  const ivec2 at = ivec2(gl_GlobalInvocationID.xy), last = textureSize(opaque_depth, 0) - 1;
  if (any(greaterThanEqual(uvec2(at), size))) return;
  float depth = 1.0;
  for (int i = 0; i < 4; ++i) depth = min(depth, texelFetch(opaque_depth, min(at * 2 + ivec2(i & 1, i >> 1), last), 0).r);
  imageStore(half_opaque, at, vec4(depth));
}
