// Stochastic transparency: the depths of one round's samples are kept beside those of the others.
#version 460
#extension GL_GOOGLE_include_directive : require

layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 9) uniform sampler2DMS samples;
layout(binding = 10, rgba32f) writeonly uniform image2DArray kept;   // a layer a round, a channel a sample
layout(push_constant) uniform Push {
  uvec2 size;
  uint slot;
};

void main() {
  const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(uvec2(pixel), size))) return;
  vec4 depths;
  for (int s = 0; s < 4; ++s) depths[s] = texelFetch(samples, pixel, s).r;
  imageStore(kept, ivec3(pixel, slot), depths);
}
