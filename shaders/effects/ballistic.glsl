// A flight under gravity, drag and wind alone, n ticks after birth, without the ticks between: what the steps of effects/step.glsl add up
// to, as sums of geometric series. With a = 1 / (1 + drag dt), wind u and w = v - u:
//   v_n = u + a^n w_0 + g dt S,                       S = sum a^k (k = 1 .. n)
//   x_n = x_0 + dt (n u + S w_0 + g dt D),            D = sum S(k) (k = 1 .. n)
// Written with decay = -ln a, share = decay / (drag dt) and lag = (1 - share) / (drag dt), no drag is no exception:
//   S = n share phi1(n decay),   D = n lag + (n share)^2 phi2(n decay),   phi1(x) = (1 - e^-x) / x,   phi2(x) = (x - 1 + e^-x) / x^2
// Error: that of rounding, below 1e-6 of the way.
#ifndef PLUME_EFFECTS_BALLISTIC_GLSL
#define PLUME_EFFECTS_BALLISTIC_GLSL
#include "effects/particle.glsl"

// Below 1 by its series, whose first term left out is x^10 / 12!: the difference would cancel.
float phi2(float x) {
  if (x >= 1.0) return (x - 1.0 + exp(-x)) / (x * x);
  float sum = 0.0;
  for (int k = 11; k >= 2; --k) sum = (1.0 - x * sum) / float(k);
  return sum;
}

Motion ballistic(EmitterData e, Motion born, uint age) {
  const float n = float(age), x = n * e.decay, late = phi2(x);
  const float s = n * e.decay_share * (1.0 - x * late);   // phi1 = 1 - x phi2
  const float d = n * e.decay_lag + n * e.decay_share * n * e.decay_share * late;
  const vec3 own = born.velocity - e.wind, falling = e.gravity * kTick;
  const vec3 velocity = e.wind + own * exp(-x) + falling * s;
  const vec3 position = born.position + (e.wind * n + own * s + falling * d) * kTick;
  return Motion(position, velocity, 0u);
}

#endif
