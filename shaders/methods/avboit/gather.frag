// AVBOIT, gather: the integer sums as the images that resolve reads.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "methods/avboit/sums.glsl"

layout(constant_id = 0) const uint kScale = 1u;      // pixels of the picture a fragment, each way
layout(constant_id = 1) const uint kEachChannel = 0u;   // weights are read for each channel
layout(push_constant) uniform Push { uvec2 size; };  // of the picture

layout(location = 0) out vec4 light;
layout(location = 1) out vec4 norm;
layout(location = 2) out vec4 norm_rgb;
layout(location = 3) out vec4 through;
layout(location = 4) out vec4 known_light;
layout(location = 5) out vec4 known_norm;

void main() {
  const uint first = first_sum(uvec2(gl_FragCoord.xy), size, kScale);
  const vec3 weights = sums(first + kNormSum);
  light = vec4(sums(first + kLightSum), exp(-sum(first + kPlainSum)));
  norm = vec4(kEachChannel != 0u ? 0.0 : weights.r);
  norm_rgb = vec4(weights, 0.0);
  through = exp(-vec4(sums(first + kThroughSum), sum(first + kThroughSum + 3u)));
  known_light = vec4(sums(first + kKnownLightSum), kEachChannel != 0u ? 0.0 : sum(first + kKnownNormSum));
  known_norm = vec4(sums(first + kKnownNormSum), 0.0);
}
