// From moments to transmittance. Of all distributions of absorbance that have these moments, the canonical one with a place at the
// depth that is asked about is found; it has kNodes other places. With w_j the shares of absorbance there,
//   T = exp(-b0 (beta w_0 + sum of w_j in front)),
// which for beta = 0 and 1 are the bounds that the moments admit (Markov, Krein), and beta = 0.25 is a guess between them.
// Muenstermann, Krumpen, Klein and Peters, I3D 2018, sections 3 and 4; the distributions are theirs, the way to them is this:
//
// The places are looked for as y = 1 / (x - w) on the line, and as y = cot((x - p) / 2) on the circle. The depth asked about is then
// infinitely far away, all others are finite, and the same real arithmetic serves both:
//   s_k  = E[(x - w)^k]        or  E[cos^(2n-k) sin^k],  of half the angle from p,  k = 1 .. 2n
//   q(y) = y^n + a_1 y^(n-1) + ... + a_n,  where  sum_j s_(k+j) a_j = -s_k:  its roots are the places, all of them real
//   the means of functions that are `beta` at the depth asked about, 1 in front of it and 0 behind: such functions within the span
//   of the moments are found by interpolation at the roots.
//
// Limits: a step in absorbance is smoothed; every fragment moves all moments, so a far one changes what is seen in front of near ones.
// The equations are nearly singular where few depths hold all absorbance: the moments are biased towards those of a wide
// distribution, as published, and pivots are kept from vanishing. `unsure` tells where that, or the fallback, was needed.
#ifndef PLUME_MOMENTS_RECONSTRUCT_GLSL
#define PLUME_MOMENTS_RECONSTRUCT_GLSL
#include "methods/moments/basis.glsl"

layout(constant_id = 3) const float kBias = 5e-7;
layout(constant_id = 4) const float kOverestimation = 0.25;

const float kLeastAbsorbance = 0.001;   // published: what less dims is not worth looking for
const float kLeastPivot = 3e-7;         // of its diagonal: a few roundings

// s[1 .. 2 kNodes] and the means that the interpolating function's coefficients are multiplied by.
void seen_from_depth(float b[8], float w, out float s[9], out float means[4]) {
  s[0] = 1.0;
  for (uint k = 0u; k < 2u * kNodes; ++k) s[k + 1u] = b[k];
  for (uint round = 1u; round <= 2u * kNodes; ++round)
    for (uint k = 2u * kNodes; k >= round; --k) s[k] -= w * s[k - 1u];
  for (uint k = 0u; k < kNodes; ++k) means[k] = s[kNodes - k];
}

void seen_from_phase(float b[8], float p, out float s[9], out float means[4]) {
  const vec2 step = vec2(cos(p), -sin(p));
  vec2 by = step;
  float c[5], d[5];   // means of the cosine and sine of k times the angle from p
  for (uint k = 1u; k <= kNodes; ++k) {
    const vec2 turned = turn(vec2(b[2u * k - 2u], b[2u * k - 1u]), by);
    c[k] = turned.x;
    d[k] = turned.y;
    by = turn(by, step);
  }
  s[0] = 0.0;   // not used
  if (kNodes == 2u) {
    s[1] = (2.0 * d[1] + d[2]) / 8.0;
    s[2] = (1.0 - c[2]) / 8.0;
    s[3] = (2.0 * d[1] - d[2]) / 8.0;
    s[4] = (3.0 - 4.0 * c[1] + c[2]) / 8.0;
    means[0] = 0.5 - 0.5 * c[1];
    means[1] = 0.5 * d[1];
    return;
  }
  means[0] = (3.0 - 4.0 * c[1] + c[2]) / 8.0;
  means[1] = (2.0 * d[1] - d[2]) / 8.0;
  means[2] = (1.0 - c[2]) / 8.0;
  means[3] = (2.0 * d[1] + d[2]) / 8.0;
  if (kNodes == 3u) {
    s[1] = (5.0 * d[1] + 4.0 * d[2] + d[3]) / 32.0;
    s[2] = (2.0 + c[1] - 2.0 * c[2] - c[3]) / 32.0;
    s[3] = (3.0 * d[1] - d[3]) / 32.0;
    s[4] = (2.0 - c[1] - 2.0 * c[2] + c[3]) / 32.0;
    s[5] = (5.0 * d[1] - 4.0 * d[2] + d[3]) / 32.0;
    s[6] = (10.0 - 15.0 * c[1] + 6.0 * c[2] - c[3]) / 32.0;
  } else {
    s[1] = (14.0 * d[1] + 14.0 * d[2] + 6.0 * d[3] + d[4]) / 128.0;
    s[2] = (5.0 + 4.0 * c[1] - 4.0 * c[2] - 4.0 * c[3] - c[4]) / 128.0;
    s[3] = (6.0 * d[1] + 2.0 * d[2] - 2.0 * d[3] - d[4]) / 128.0;
    s[4] = (3.0 - 4.0 * c[2] + c[4]) / 128.0;
    s[5] = (6.0 * d[1] - 2.0 * d[2] - 2.0 * d[3] + d[4]) / 128.0;
    s[6] = (5.0 - 4.0 * c[1] - 4.0 * c[2] + 4.0 * c[3] - c[4]) / 128.0;
    s[7] = (14.0 * d[1] - 14.0 * d[2] + 6.0 * d[3] - d[4]) / 128.0;
    s[8] = (35.0 - 56.0 * c[1] + 28.0 * c[2] - 8.0 * c[3] + c[4]) / 128.0;
  }
}

// Coefficients a_1 .. a_n of q(y), by Cholesky's decomposition without roots. True where a pivot had to be kept up.
bool solve(float s[9], out float a[4]) {
  float lower[4][4], pivot[4];
  bool kept_up = false;
  for (uint i = 0u; i < kNodes; ++i) {
    const float diagonal = s[2u * i + 2u];
    pivot[i] = diagonal;
    for (uint k = 0u; k < i; ++k) pivot[i] -= lower[i][k] * lower[i][k] * pivot[k];
    const float least = max(diagonal * kLeastPivot, 1e-30);
    kept_up = kept_up || pivot[i] < least;
    pivot[i] = max(pivot[i], least);
    for (uint j = i + 1u; j < kNodes; ++j) {
      lower[j][i] = s[i + j + 2u];
      for (uint k = 0u; k < i; ++k) lower[j][i] -= lower[j][k] * lower[i][k] * pivot[k];
      lower[j][i] /= pivot[i];
    }
    a[i] = -s[i + 1u];
    for (uint k = 0u; k < i; ++k) a[i] -= lower[i][k] * a[k];
  }
  for (uint i = 0u; i < kNodes; ++i) a[i] /= pivot[i];
  for (uint i = kNodes - 1u; i-- > 0u;)
    for (uint k = i + 1u; k < kNodes; ++k) a[i] -= lower[k][i] * a[k];
  return kept_up;
}

// The roots of y^3 + a y^2 + b y + c, all of them real: three cosines.
vec3 cubic_roots(float a, float b, float c) {
  const float shift = a / 3.0, third_p = b / 3.0 - shift * shift;
  const float half_q = 0.5 * (shift * (2.0 * shift * shift - b) + c);
  const float m = sqrt(max(-third_p, 0.0));
  const float angle = acos(clamp(-half_q / max(m * m * m, 1e-37), -1.0, 1.0)) / 3.0;
  return 2.0 * m * cos(angle - vec3(0.0, 2.0, 4.0) * (kPi / 3.0)) - shift;
}

// The roots of y^4 + a y^3 + b y^2 + c y + d, all of them real: half sums of the roots of Euler's resolvent, which are squares.
vec4 quartic_roots(float a, float b, float c, float d) {
  const float h = 0.25 * a, hh = h * h;
  const float p = b - 6.0 * hh, q = c - 2.0 * b * h + 8.0 * h * hh, r = d - c * h + b * hh - 3.0 * hh * hh;
  vec3 u = sqrt(max(cubic_roots(2.0 * p, p * p - 4.0 * r, -q * q), vec3(0.0)));
  if (q > 0.0) u.z = -u.z;   // the product of the three is -q
  return 0.5 * vec4(u.x + u.y + u.z, u.x - u.y - u.z, u.y - u.x - u.z, u.z - u.x - u.y) - h;
}

void roots(float a[4], out float y[4]) {
  if (kNodes == 2u) {
    const float h = -0.5 * a[0], spread = sqrt(max(h * h - a[1], 0.0));
    y[0] = h < 0.0 ? h - spread : h + spread;
    y[1] = y[0] != 0.0 ? a[1] / y[0] : 0.0;
    return;
  }
  if (kNodes == 3u) {
    const vec3 found = cubic_roots(a[0], a[1], a[2]);
    for (uint i = 0u; i < 3u; ++i) y[i] = found[i];
  } else {
    const vec4 found = quartic_roots(a[0], a[1], a[2], a[3]);
    for (uint i = 0u; i < 4u; ++i) y[i] = found[i];
  }
  // One step of Weierstrass: all roots at once, so that no two of them run into one.
  float refined[4];
  for (uint i = 0u; i < kNodes; ++i) {
    float value = y[i] + a[0], apart = 1.0;
    for (uint k = 1u; k < kNodes; ++k) value = value * y[i] + a[k];
    for (uint k = 0u; k < kNodes; ++k)
      if (k != i) apart *= y[i] - y[k];
    refined[i] = apart != 0.0 ? y[i] - value / apart : y[i];
  }
  for (uint i = 0u; i < kNodes; ++i) y[i] = refined[i];
}

// 1 where the place of a root is in front of the depth asked about, 0 where it is behind. On the circle "in front" ends somewhere in
// the zone that no fragment is in, where it rises evenly, as published.
float in_front(float y, float p) {
  if (kPower) return y < 0.0 ? 1.0 : 0.0;
  const float angle = p + 2.0 * atan(1.0, y);
  return angle >= 2.0 * kPi ? 1.0 : clamp((angle - 2.0 * kPi) / kWrappingZone + 1.0, 0.0, 1.0);
}

// Share of all absorbance that lies in front of warped depth w; of what lies there itself, kOverestimation. `low` and `high` are the
// moments divided by b0.
float share_in_front(vec4 low, vec4 high, float w, out bool unsure) {
  if (kPower) {
    const vec4 wide_low = kNodes == 2u ? vec4(0.0, 0.375, 0.0, 0.375) : kNodes == 3u ? vec4(0.0, 0.48, 0.0, 0.451) : vec4(0.0, 0.75, 0.0, 0.67667);
    const vec4 wide_high = kNodes == 3u ? vec4(0.0, 0.45, 0.0, 0.0) : vec4(0.0, 0.63, 0.0, 0.60030);
    low = mix(low, wide_low, kBias);
    high = mix(high, wide_high, kBias);
  } else {   // evenly around the circle
    low *= 1.0 - kBias;
    high *= 1.0 - kBias;
  }
  float b[8] = float[8](low.x, low.y, low.z, low.w, high.x, high.y, high.z, high.w);
  float s[9], means[4], a[4], y[4], value[4], coefficient[4];
  const float p = phase_of(w);
  if (kPower) seen_from_depth(b, w, s, means);
  else seen_from_phase(b, p, s, means);
  unsure = solve(s, a);
  roots(a, y);
  for (uint i = 0u; i < kNodes; ++i) {
    const float square = kPower ? y[i] * y[i] : 1.0 + y[i] * y[i];
    float scale = square;
    if (kNodes == 4u || (kNodes == 3u && !kPower)) scale *= square;
    if (kNodes == 3u && kPower) scale *= y[i];
    value[i] = (in_front(y[i], p) - kOverestimation) * scale;
  }
  // Newton's divided differences, then the coefficients of 1, y, y^2, ...
  for (uint k = 1u; k < kNodes; ++k)
    for (uint i = kNodes - 1u; i >= k; --i) {
      const float apart = y[i] - y[i - k];
      value[i] = apart != 0.0 ? (value[i] - value[i - 1u]) / apart : 0.0;
    }
  coefficient[0] = value[kNodes - 1u];
  for (uint k = 1u; k < kNodes; ++k) {
    const uint node = kNodes - 1u - k;
    coefficient[k] = coefficient[k - 1u];
    for (uint i = k - 1u; i > 0u; --i) coefficient[i] = coefficient[i - 1u] - y[node] * coefficient[i];
    coefficient[0] = value[node] - y[node] * coefficient[0];
  }
  float share = kOverestimation;
  for (uint k = 0u; k < kNodes; ++k) share += coefficient[k] * means[k];
  if (isnan(share) || isinf(share)) {   // everything is in one place: that of the fragment itself
    unsure = true;
    return kOverestimation;
  }
  return clamp(share, 0.0, 1.0);
}

// `low` and `high` as they were summed.
float transmittance_of(float b0, vec4 low, vec4 high, float w, out bool unsure) {
  unsure = false;
  if (b0 < kLeastAbsorbance) return 1.0;
  return exp(-b0 * share_in_front(low / b0, high / b0, w, unsure));
}

#endif
