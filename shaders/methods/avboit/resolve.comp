// AVBOIT, resolve:  image = (sum C a w) (1 - e^-tau) / (sum a w) + emission + background e^-tau,  tau = sum of optical depths.
#version 460
#extension GL_GOOGLE_include_directive : require

layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 8) uniform sampler2D accum;
layout(binding = 9) uniform sampler2D optical_depth;
layout(binding = 10) uniform sampler2D emission;
layout(binding = 11) uniform sampler2D opaque_color;
layout(binding = 12, rgba16f) writeonly uniform image2D result;
layout(push_constant) uniform Push { uvec2 size; };

void main() {
  const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(uvec2(pixel), size))) return;
  const vec4 sums = texelFetch(accum, pixel, 0);
  const float through = exp(-texelFetch(optical_depth, pixel, 0).r);
  const vec3 average = sums.a > 0.0 ? sums.rgb / sums.a : vec3(0.0);
  const vec3 light = average * (1.0 - through) + texelFetch(emission, pixel, 0).rgb;
  imageStore(result, pixel, vec4(light + texelFetch(opaque_color, pixel, 0).rgb * through, 1.0));
}
