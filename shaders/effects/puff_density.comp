// Puff textures, step 1: a small 3-D cloud per layer (a ball with hills of folded noise that moves in a circle, so that the flipbook
// loops) is marched from the front. Writes (optical depth, mean height of what is seen from the front) in units of the radius.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "effects/puff.h"
#include "shared/hash.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(scalar, binding = 0) writeonly buffer March { vec2 march[]; };
layout(push_constant) uniform Push { uint seed; };

const uint kSteps = 24u;
const float kExtinction = 5.0;   // 1/radius inside the puff, for the height only

float value_noise(vec3 p, uint salt) {
  const vec3 base = floor(p), f = p - base, u = f * f * (3.0 - 2.0 * f);
  const uvec3 q = uvec3(ivec3(base));
  float corner[8];
  for (uint i = 0u; i < 8u; ++i) {
    const uvec3 at = q + uvec3(i & 1u, (i >> 1u) & 1u, i >> 2u);
    corner[i] = float(hash(at.x + hash(at.y + hash(at.z + salt))) >> 8u) * (1.0 / 16777216.0);
  }
  const vec4 x = mix(vec4(corner[0], corner[2], corner[4], corner[6]), vec4(corner[1], corner[3], corner[5], corner[7]), u.x);
  const vec2 y = mix(x.xz, x.yw, u.y);
  return mix(y.x, y.y, u.z);
}

// Folded noise: round hills between narrow creases, as on a cauliflower, where smoke rolls outwards.
float billow_noise(vec3 p, uint salt) {
  float sum = 0.0, weight = 0.5;
  for (uint octave = 0u; octave < 4u; ++octave) {
    sum += weight * abs(2.0 * value_noise(p, salt + octave) - 1.0);
    p = p * 2.07 + 3.1;
    weight *= 0.55;
  }
  return sum;   // about 0.05 .. 0.75
}

float density(vec3 p, float phase, uint salt) {
  const vec3 drift = 0.55 * vec3(cos(phase), sin(phase), 0.5 * cos(phase));
  const float hills = billow_noise(p * 1.7 + drift + 20.0, salt);
  return smoothstep(0.0, 0.5, 0.35 - length(p) + 1.1 * hills);
}

void main() {
  const uvec3 at = gl_GlobalInvocationID;
  if (any(greaterThanEqual(at.xy, uvec2(kPuffSize)))) return;
  const vec2 uv = (vec2(at.xy) + 0.5) / float(kPuffSize) * 2.0 - 1.0;
  const float phase = 6.2831853 * float(at.z % kPuffFrames) / float(kPuffFrames);
  const uint salt = hash_pair(seed, at.z / kPuffFrames);
  float tau = 0.0, seen = 0.0, height = 0.0;
  const float step_length = 2.0 / float(kSteps);
  for (uint i = 0u; i < kSteps; ++i) {
    const float z = 1.0 - (float(i) + 0.5) * step_length;
    if (dot(uv, uv) + z * z >= 1.0) continue;
    const float here = density(vec3(uv, z), phase, salt) * step_length;
    const float caught = exp(-kExtinction * tau) * (1.0 - exp(-kExtinction * here));
    tau += here;
    seen += caught;
    height += caught * z;
  }
  const float sphere = sqrt(max(1.0 - dot(uv, uv), 0.0));
  march[(at.z * kPuffSize + at.y) * kPuffSize + at.x] = vec2(tau, (height + sphere * 0.5 * (1.0 - seen)) );
}
