// AVBOIT, draw: every fragment in any order; integers are added up.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "methods/avboit/accumulate.glsl"
#include "methods/avboit/sums.glsl"

layout(early_fragment_tests) in;

void main() {
  const Share share = share_of_fragment();
  const uint first = first_sum(uvec2(gl_FragCoord.xy), view.size, kScale);
  add_sums(first + kLightSum, share.light.rgb);
  add_sums(first + kNormSum, kEachChannel != 0u ? share.norm : share.norm.rrr);
  if (kTints != 0u) {
    add_sums(first + kThroughSum, vec3(logarithm(share.through.r), logarithm(share.through.g), logarithm(share.through.b)));
    add_sum(first + kThroughSum + 3u, logarithm(share.through.a));
  } else {
    add_sum(first + kPlainSum, logarithm(share.light.a));
  }
  if (kExact != 0u) {
    add_sums(first + kKnownLightSum, share.known_light);
    add_sums(first + kKnownNormSum, share.known_norm);
  }
}
