// Phenomenological transparency, the composite:
//   image = (sum C w) / (sum a' w) (1 - B) + emission + background' B,   B = prod(1 - a (1 - t)) for each channel,
// where background' is the opaque image, looked up where the light was bent to and blurred with a Gaussian of the summed variance.
// Self-modulation lets what is drawn take half of the hue of B: layers are seen through one another.
// What is nearer than the surfaces that bend is left out of the blur.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/view.h"
#include "methods/parts/weighted/overflow.glsl"
#include "methods/phenomenological/self_modulation.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = 0) const uint kSelfModulation = 1u;
layout(constant_id = 1) const uint kBlurRadius = 32u;   // pixels: three standard deviations end here at the latest
layout(constant_id = 2) const uint kFullFloats = 0u;
layout(scalar, binding = 0) uniform View { ViewData view; };
layout(binding = 8) uniform sampler2D accum;
layout(binding = 9) uniform sampler2D modulation;
layout(binding = 10) uniform sampler2D emission;
layout(binding = 11) uniform sampler2D bent;
layout(binding = 12) uniform sampler2D opaque_color;
layout(binding = 13) uniform sampler2D opaque_depth;
layout(binding = 14, rgba16f) writeonly uniform image2D result;
layout(std430, binding = 15) buffer Counts {
  uint overflowed_pixels;
  uint clipped_pixels;   // whose blur was wider than the radius
};
layout(push_constant) uniform Push { uvec2 size; };

const int kMostSteps = 8;   // of the blur, each way from the middle

// Depth in front of which things are not seen through what bends, as near_m / depth.
float nearest_bent(vec4 at) { return at.w * view.near_m / max(at.z + length(at.xy), 1e-9); }

vec3 background(ivec2 pixel) {
  const vec4 here = texelFetch(bent, pixel, 0);
  const vec3 straight = texelFetch(opaque_color, pixel, 0).rgb;
  const float limit = nearest_bent(here);
  vec2 place = vec2(pixel) + 0.5;
  if (here.xy != vec2(0.0)) {
    const vec4 depths = textureGather(opaque_depth, (place + here.xy) / vec2(size));
    if (max(max(depths.x, depths.y), max(depths.z, depths.w)) <= limit) place += here.xy;
  }
  const float deviation = sqrt(here.z), wanted = 3.0 * deviation, radius = min(wanted, float(kBlurRadius));
  if (wanted > float(kBlurRadius)) atomicAdd(clipped_pixels, 1u);
  if (radius < 0.25) return here.xy == vec2(0.0) ? straight : textureLod(opaque_color, place / vec2(size), 0.0).rgb;
  const int most = clamp(int(ceil(radius)), 1, kMostSteps);
  const float step = radius / float(most);
  vec3 sum = vec3(0.0);
  float total = 0.0;
  for (int y = -most; y <= most; ++y)
    for (int x = -most; x <= most; ++x) {
      const vec2 aside = vec2(x, y) * step, at = clamp(place + aside, vec2(0.5), vec2(size) - 0.5);
      const float seen = texelFetch(opaque_depth, ivec2(at), 0).r <= limit && dot(aside, aside) <= radius * radius * 1.0001 ? 1.0 : 0.0;
      const float share = seen * exp(-0.5 * dot(aside, aside) / here.z);
      sum += share * textureLod(opaque_color, at / vec2(size), 0.0).rgb;
      total += share;
    }
  return total > 0.0 ? sum / total : straight;
}

void main() {
  const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(uvec2(pixel), size))) return;
  vec4 sums = texelFetch(accum, pixel, 0);
  const bvec4 over = overflowed(sums, kFullFloats != 0u);
  if (any(over)) atomicAdd(overflowed_pixels, 1u);
  if (any(over.rgb)) sums = vec4(1.0);
  else if (over.a) sums.a = brightest(sums.rgb);   // keeps the hue where only the weights overflowed
  const vec3 b = texelFetch(modulation, pixel, 0).rgb;
  vec3 mean = sums.rgb / max(sums.a, 1e-5);
  if (kSelfModulation != 0u) mean *= self_modulation(b);
  const vec3 light = mean * (1.0 - b) + texelFetch(emission, pixel, 0).rgb;
  imageStore(result, pixel, vec4(light + background(pixel) * b, 1.0));
}
