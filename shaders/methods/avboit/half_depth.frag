// The farthest visible depth of 2 x 2 pixels, as the depth buffer of half-resolution particles.
#version 460
layout(binding = 8) uniform sampler2D visible_depth;

void main() {
  const ivec2 at = ivec2(gl_FragCoord.xy), last = textureSize(visible_depth, 0) - 1;
  float depth = 1.0;
  for (int i = 0; i < 4; ++i) depth = min(depth, texelFetch(visible_depth, min(at * 2 + ivec2(i & 1, i >> 1), last), 0).r);
  gl_FragDepth = depth;
}
