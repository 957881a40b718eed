// A fire as one light: a work group sums its glowing particles in a fixed order. With l the luminance of a particle's power,
//   power     P = sum(emission * area) / pi * (1 - exp(-t)) / t     light that leaves a ball which absorbs as evenly as it emits,
//             t = sum(l a) sum(l) / (sum(l^2) pi R^2)               its optical depth: mean covered area times effective number
// times the scene's gain: pictures hold less than flames have, and 1 is what the picture shows.
//   position  sum(l x) / sum(l),     radius  R^2 = 5/3 var(x) + mean r^2   (the variance of an even ball is 3/5 R^2)
// A fire too dim or too bright for l^2 to be a number lights nothing.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "effects/light_body.glsl"
#include "shared/bad_number.h"

layout(local_size_x = 64) in;
layout(scalar, binding = 1) readonly buffer Bodies { LitBody bodies[]; };
layout(scalar, binding = 6) readonly buffer Sources { FireSource sources[]; };
layout(scalar, binding = 7) readonly buffer Ranges { FireRange ranges[]; };
layout(scalar, binding = 23) writeonly buffer Fires {
  uint fire_count;
  FireLight fires[];
};

layout(push_constant) uniform Push { float gain; };

struct Sums {
  vec3 power;
  float l;
  vec3 arm;           // of l
  float squared_arm;
  float squared_radius;
  float covered;
  float squared_l;
};

const float kLeastSquare = 1.2e-38;   // less may be flushed to 0

shared Sums sums[64];

Sums add(Sums a, Sums b) {
  return Sums(a.power + b.power, a.l + b.l, a.arm + b.arm, a.squared_arm + b.squared_arm, a.squared_radius + b.squared_radius,
              a.covered + b.covered, a.squared_l + b.squared_l);
}

Sums of_body(LitBody body, vec3 origin) {
  const vec3 arm = body.position - origin;
  const float l = dot(body.power, vec3(0.2126, 0.7152, 0.0722)), squared_radius = body.radius * body.radius;
  return Sums(body.power, l, l * arm, l * dot(arm, arm), l * squared_radius,
              l * 3.14159265 * squared_radius * (1.0 - exp(-body.depth)), l * l);
}

void main() {
  const uint lane = gl_LocalInvocationIndex;
  const FireSource source = sources[gl_WorkGroupID.x];
  Sums sum = Sums(vec3(0.0), 0.0, vec3(0.0), 0.0, 0.0, 0.0, 0.0);
  for (uint r = source.first; r < source.first + source.count; ++r)
    for (uint i = lane; i < ranges[r].count; i += 64u) sum = add(sum, of_body(bodies[ranges[r].first + i], source.origin));
  sums[lane] = sum;
  for (uint step = 32u; step > 0u; step /= 2u) {
    barrier();
    if (lane < step) sums[lane] = add(sums[lane], sums[lane + step]);
  }
  if (lane > 0u) return;
  sum = sums[0];
  FireLight fire = FireLight(source.origin, 1.0, vec3(0.0), 1.0);
  if (sum.squared_l >= kLeastSquare && !is_bad(sum.squared_l)) {
    const vec3 arm = sum.arm / sum.l;
    fire.position += arm;
    fire.radius_squared = 5.0 / 3.0 * max(sum.squared_arm / sum.l - dot(arm, arm), 0.0) + sum.squared_radius / sum.l;
    fire.radius = sqrt(fire.radius_squared);
    const float t = sum.covered / sum.squared_l * (sum.l / (3.14159265 * fire.radius_squared));
    fire.power = gain * sum.power * (t > 0.01 ? (1.0 - exp(-t)) / t : 1.0 - 0.5 * t);
  }
  fires[gl_WorkGroupID.x] = fire;
  if (gl_WorkGroupID.x == 0u) fire_count = gl_NumWorkGroups.x;
}
