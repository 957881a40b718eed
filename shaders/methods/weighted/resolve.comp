// Weighted blended transparency, the composite: normalises the sums and adds the background that shows through.
#version 460
#extension GL_GOOGLE_include_directive : require

layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = 0) const uint kEachChannel = 0u;
layout(constant_id = 1) const uint kNormalise = 1u;   // 0: the weights are believed as they are
layout(binding = 8) uniform sampler2D accum;
layout(binding = 9) uniform sampler2D through;
layout(binding = 10) uniform sampler2D emission;
layout(binding = 11) uniform sampler2D norm;   // where kEachChannel
layout(binding = 12) uniform sampler2D opaque_color;
layout(binding = 13, rgba16f) writeonly uniform image2D result;
layout(push_constant) uniform Push { uvec2 size; };

void main() {
  const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(uvec2(pixel), size))) return;
  vec4 sums = texelFetch(accum, pixel, 0);
  const vec4 passed = texelFetch(through, pixel, 0);
  const vec3 t = kEachChannel != 0u ? passed.rgb : passed.rrr;
  vec3 light = sums.rgb;
  if (kNormalise != 0u) {
    const vec3 weights = kEachChannel != 0u ? texelFetch(norm, pixel, 0).rgb : sums.aaa;
    // 16-bit sums overflow at about 22 fragments of weight 3000: McGuire's 2015 post replaces the colour by the coverage.
    if (any(isinf(light))) light = weights;
    light = (1.0 - t) * mix(light / max(weights, vec3(1e-5)), vec3(1.0), isinf(weights));
  }
  light += texelFetch(emission, pixel, 0).rgb;
  imageStore(result, pixel, vec4(light + texelFetch(opaque_color, pixel, 0).rgb * t, 1.0));
}
