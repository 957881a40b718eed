// Weighted blended transparency, the composite: normalises the sums and adds the background that is revealed.
#version 460
#extension GL_GOOGLE_include_directive : require

layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 8) uniform sampler2D accum;
layout(binding = 9) uniform sampler2D revealage;
layout(binding = 10) uniform sampler2D emission;
layout(binding = 11) uniform sampler2D opaque_color;
layout(binding = 12, rgba16f) writeonly uniform image2D result;
layout(push_constant) uniform Push { uvec2 size; };

void main() {
  const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(uvec2(pixel), size))) return;
  vec4 sums = texelFetch(accum, pixel, 0);
  const float reveal = texelFetch(revealage, pixel, 0).r;
  // 16-bit sums overflow at about 22 fragments of weight 3000: McGuire's 2015 post replaces the colour by the coverage.
  if (any(isinf(sums.rgb))) sums.rgb = vec3(sums.a);
  const vec3 average = isinf(sums.a) ? vec3(1.0) : sums.rgb / max(sums.a, 1e-5);
  const vec3 light = average * (1.0 - reveal) + texelFetch(emission, pixel, 0).rgb;
  imageStore(result, pixel, vec4(light + texelFetch(opaque_color, pixel, 0).rgb * reveal, 1.0));
}
