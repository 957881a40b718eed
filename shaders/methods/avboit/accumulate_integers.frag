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
  if (share.through != vec4(1.0)) {
    add_sums(first + kThroughSum, vec3(logarithm(share.through.r), logarithm(share.through.g), logarithm(share.through.b)));
    add_sum(first + kThroughSum + 3u, logarithm(share.through.a));
  } else if (share.light.a != 1.0) {
    add_sum(first + kPlainSum, logarithm(share.light.a));
  }
  if (kExact != 0u || kDoubt != 0u) {
    add_sums(first + kKnownLightSum, share.known_light);
    add_sums(first + kKnownNormSum, kEachChannel != 0u ? share.known_norm : share.known_norm.rrr);
  }
}
