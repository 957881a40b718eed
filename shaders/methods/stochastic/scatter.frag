// Stochastic transparency, depth: a fragment covers a random choice of its pixel's samples, each with a probability of its coverage a,
//   floor(S a + xi) of the S samples, xi uniform in [0, 1)       (stratified; Enderton et al., I3D 2010, section 3)
// and the depth test keeps the nearest that covers each. Choices of different fragments are independent, so a sample is left to what
// lies at z with a probability of prod (1 - a) over those in front: their transmittance.
//
// All samples get the depth at the pixel's centre, cards come grown by a pixel (grown.vert), and a fragment whose centre lies off the
// card is none: a pixel holds the same fragments as in every other method, and at edges too each offers itself to all its samples.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "surface/shade.glsl"
#include "shared/hash.h"
#include "methods/stochastic/plane_depth.glsl"
#include "methods/stochastic/stochastic.h"

layout(scalar, binding = 8) readonly buffer Round { StochasticRound round_; };

const uint kPairs = 0xca6953u;   // the masks of two samples out of four
const float kUnit = 1.0 / 16777216.0;   // of 24 random bits

uint random_mask(float alpha, uint bits, uint choice) {
  const uint number = min(uint(float(kSamplesARound) * alpha + float(bits >> 8u) * kUnit), kSamplesARound);
  const uint one = 1u << (choice >> 30u);
  switch (number) {
    case 0u: return 0u;
    case 1u: return one;
    case 2u: return kPairs >> (4u * ((choice >> 8u) * 3u >> 23u)) & 15u;
    case 3u: return 15u ^ one;
    default: return 15u;
  }
}

void main() {
  if (!on_card()) discard;
  const float alpha = coverage_of(density(puff_texel())) * (1.0 - dot(v_transmission.rgb, vec3(1.0 / 3.0)));
  const uvec2 pixel = uvec2(gl_FragCoord.xy);
  const uint drawing = hash_pair(view.tick, hash_pair(round_.round, round_.seed));
  const uint bits = hash_pair(v_layers_id.z, hash_pair(pixel.y << 16u | pixel.x, drawing));
  const uint mask = random_mask(alpha, bits, hash(bits));
  if (mask == 0u) discard;
  gl_SampleMask[0] = int(mask);
  gl_FragDepth = plane_depth();
}
