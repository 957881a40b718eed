// The transmittance in front of a depth at a pixel, from the images of moments. Where those are coarser than the picture they are
// interpolated between the four texels around the pixel: sums of absorbance are, not transmittance, so what is read is what a mixture of
// the four would have summed.
#ifndef PLUME_MOMENTS_TRANSMITTANCE_GLSL
#define PLUME_MOMENTS_TRANSMITTANCE_GLSL
#include "methods/moments/reconstruct.glsl"

layout(constant_id = 1) const uint kRgb = 0u;
layout(constant_id = 2) const uint kDivisor = 1u;
layout(scalar, binding = 8) uniform Warp { DepthWarp warp; };
layout(binding = 9) uniform sampler2D b0;
layout(binding = 10) uniform sampler2D low_r;
layout(binding = 11) uniform sampler2D high_r;
layout(binding = 12) uniform sampler2D low_g;
layout(binding = 13) uniform sampler2D high_g;
layout(binding = 14) uniform sampler2D low_b;
layout(binding = 15) uniform sampler2D high_b;

struct Texels {
  ivec2 at[4];
  vec4 part;
};

// Written out by hand: 32-bit float images need not be filtered by the device.
Texels texels_around(ivec2 pixel) {
  Texels t;
  const vec2 place = (vec2(pixel) + 0.5) / float(kDivisor) - 0.5, g = fract(place);
  const ivec2 last = textureSize(b0, 0) - 1, corner = ivec2(floor(place));
  for (int i = 0; i < 4; ++i) t.at[i] = clamp(corner + ivec2(i & 1, i >> 1), ivec2(0), last);
  t.part = vec4((1.0 - g.x) * (1.0 - g.y), g.x * (1.0 - g.y), (1.0 - g.x) * g.y, g.x * g.y);
  return t;
}

vec4 read(sampler2D image, ivec2 pixel, Texels t) {
  if (kDivisor == 1u) return texelFetch(image, pixel, 0);
  return t.part.x * texelFetch(image, t.at[0], 0) + t.part.y * texelFetch(image, t.at[1], 0) + t.part.z * texelFetch(image, t.at[2], 0) +
         t.part.w * texelFetch(image, t.at[3], 0);
}

vec3 transmittance_at(ivec2 pixel, float depth, out bool unsure) {
  Texels t;
  if (kDivisor > 1u) t = texels_around(pixel);
  const float w = warped(warp, depth);
  const vec3 mass = read(b0, pixel, t).rgb;
  const float first = transmittance_of(mass.r, read(low_r, pixel, t), kHigh ? read(high_r, pixel, t) : vec4(0.0), w, unsure);
  if (kRgb == 0u) return vec3(first);
  bool unsure_g, unsure_b;
  const float second = transmittance_of(mass.g, read(low_g, pixel, t), kHigh ? read(high_g, pixel, t) : vec4(0.0), w, unsure_g);
  const float third = transmittance_of(mass.b, read(low_b, pixel, t), kHigh ? read(high_b, pixel, t) : vec4(0.0), w, unsure_b);
  unsure = unsure || unsure_g || unsure_b;
  return vec3(first, second, third);
}

// All weights of a pixel may be small, for T in front of the first of several opaque fragments is already exp(-beta w_0 b0). A common factor
// cancels in the fraction, whose denominator has a floor.
const float kWeightScale = exp2(64.0);

#endif
