// Weighted blended transparency, the composite: normalises the sums and adds the background that shows through.
#version 460
#extension GL_GOOGLE_include_directive : require

layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = 0) const uint kEachChannel = 0u;
layout(constant_id = 1) const uint kNormalise = 1u;   // 0: the weights are believed as they are
layout(constant_id = 2) const uint kModulates = 0u;   // the background is multiplied by `modulation`, not by prod t
layout(constant_id = 3) const uint kDivisor = 1u;
layout(constant_id = 4) const uint kFullFloats = 0u;

#include "methods/parts/weighted/overflow.glsl"
#include "methods/parts/weighted/sums.glsl"

layout(binding = 11) uniform sampler2D norm;         // where kEachChannel
layout(binding = 12) uniform sampler2D opaque_color;
layout(binding = 13, rgba16f) writeonly uniform image2D result;
layout(binding = 14) uniform sampler2D modulation;   // where kModulates
layout(std430, binding = 15) buffer Overflowed { uint overflowed_pixels; };
layout(push_constant) uniform Push { uvec2 size; };

void main() {
  const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(uvec2(pixel), size))) return;
  const Sums s = sums_at(pixel);
  const vec3 t = kEachChannel != 0u ? s.through.rgb : s.through.rrr;
  vec3 light = s.accum.rgb;
  const bvec4 over = overflowed(s.accum, kFullFloats != 0u);
  if (any(over)) atomicAdd(overflowed_pixels, 1u);
  if (kNormalise != 0u) {
    const vec3 weights = kEachChannel != 0u ? texelFetch(norm, pixel, 0).rgb : s.accum.aaa;
    const bvec3 over_weights = kEachChannel != 0u ? overflowed(weights.rgbb, kFullFloats != 0u).rgb : over.aaa;
    // 16-bit sums overflow at about 22 fragments of weight 3000: McGuire's 2015 post replaces the colour by the coverage.
    if (any(over.rgb)) light = weights;
    light = (1.0 - t) * mix(light / max(weights, vec3(1e-5)), vec3(1.0), over_weights);
  }
  const vec3 passed = kModulates != 0u ? texelFetch(modulation, pixel, 0).rgb : t;
  light += s.emission;
  imageStore(result, pixel, vec4(light + texelFetch(opaque_color, pixel, 0).rgb * passed, 1.0));
}
