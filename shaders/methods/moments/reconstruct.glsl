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

// s_1 .. s_8 and the means of 1, y, y^2, y^3 under the weight that the interpolated values are scaled by. Written out, because arrays
// indexed in loops are slow where a compiler leaves them in memory; what a kind has no use for is not computed.
struct Seen {
  vec4 near;   // s_1 .. s_4
  vec4 far;    // s_5 .. s_8
  vec4 means;
};

// By one factor x - w after the other: binomial coefficients would take two more digits.
Seen seen_from_depth(vec4 b, vec4 c, float w) {   // b: moments 1 to 4, c: 5 to 8
  Seen s = Seen(b, c, vec4(0.0));
  s.far -= w * vec4(s.near.w, s.far.xyz);
  s.near -= w * vec4(1.0, s.near.xyz);
  s.far -= w * vec4(s.near.w, s.far.xyz);
  s.near.yzw -= w * s.near.xyz;
  s.far -= w * vec4(s.near.w, s.far.xyz);
  s.near.zw -= w * s.near.yz;
  s.far -= w * vec4(s.near.w, s.far.xyz);
  s.near.w -= w * s.near.z;
  s.far -= w * vec4(s.near.w, s.far.xyz);
  s.far.yzw -= w * s.far.xyz;
  s.far.zw -= w * s.far.yz;
  s.far.w -= w * s.far.z;
  s.means = kNodes == 2u ? s.near.yxxx : kNodes == 3u ? s.near.zyxx : s.near.wzyx;
  return s;
}

Seen seen_from_phase(vec4 b, vec4 c, float p) {
  const vec2 once = vec2(cos(p), -sin(p)), twice = turn(once, once);
  const vec2 e = turn(b.xy, once), f = turn(b.zw, twice);   // means of (cos, sin) of the angle from p, and of twice that
  Seen s;
  s.means = vec4(3.0 - 4.0 * e.x + f.x, 2.0 * e.y - f.y, 1.0 - f.x, 2.0 * e.y + f.y) / 8.0;
  if (kNodes == 2u) {
    s.near = s.means.wzyx;
    s.far = vec4(0.0);
    s.means = vec4(0.5 - 0.5 * e.x, 0.5 * e.y, 0.0, 0.0);
    return s;
  }
  const vec2 g = turn(c.xy, turn(twice, once));
  if (kNodes == 3u) {
    s.near = vec4(5.0 * e.y + 4.0 * f.y + g.y, 2.0 + e.x - 2.0 * f.x - g.x, 3.0 * e.y - g.y, 2.0 - e.x - 2.0 * f.x + g.x) / 32.0;
    s.far = vec4(5.0 * e.y - 4.0 * f.y + g.y, 10.0 - 15.0 * e.x + 6.0 * f.x - g.x, 0.0, 0.0) / 32.0;
  } else {
    const vec2 h = turn(c.zw, turn(twice, twice));
    s.near = vec4(14.0 * e.y + 14.0 * f.y + 6.0 * g.y + h.y, 5.0 + 4.0 * e.x - 4.0 * f.x - 4.0 * g.x - h.x,
                  6.0 * e.y + 2.0 * f.y - 2.0 * g.y - h.y, 3.0 - 4.0 * f.x + h.x) / 128.0;
    s.far = vec4(6.0 * e.y - 2.0 * f.y - 2.0 * g.y + h.y, 5.0 - 4.0 * e.x - 4.0 * f.x + 4.0 * g.x - h.x,
                 14.0 * e.y - 14.0 * f.y + 6.0 * g.y - h.y, 35.0 - 56.0 * e.x + 28.0 * f.x - 8.0 * g.x + h.x) / 128.0;
  }
  return s;
}

// Keeps a pivot from vanishing beside the diagonal that it is what is left of.
float kept_up(float pivot, float diagonal, inout bool unsure) {
  const float least = max(diagonal * kLeastPivot, 1e-30);
  unsure = unsure || !(pivot >= least);
  return max(pivot, least);
}

// Coefficients a_1 .. a_n of q(y), by Cholesky's decomposition without roots.
vec4 solve(Seen s, out bool unsure) {
  unsure = false;
  const vec4 d = vec4(s.near.y, s.near.w, s.far.y, s.far.w);   // the diagonal
  const float p0 = kept_up(d.x, d.x, unsure);
  const vec3 l0 = vec3(s.near.zw, s.far.x) / p0;
  const float p1 = kept_up(d.y - l0.x * s.near.z, d.y, unsure);
  vec4 x = vec4(-s.near.x, -s.near.y, -s.near.z, -s.near.w);
  x.y -= l0.x * x.x;
  if (kNodes == 2u) {
    const float a = x.y / p1;
    return vec4(x.x / p0 - l0.x * a, a, 0.0, 0.0);
  }
  const vec2 left1 = s.far.xy - l0.yz * s.near.z, l1 = left1 / p1;
  const float p2 = kept_up(d.z - l0.y * s.near.w - l1.x * left1.x, d.z, unsure);
  x.z -= l0.y * x.x + l1.x * x.y;
  if (kNodes == 3u) {
    const float a = x.z / p2, b = x.y / p1 - l1.x * a;
    return vec4(x.x / p0 - l0.x * b - l0.y * a, b, a, 0.0);
  }
  const float left2 = s.far.z - l0.z * s.near.w - l1.y * left1.x, l2 = left2 / p2;
  const float p3 = kept_up(d.w - l0.z * s.far.x - l1.y * left1.y - l2 * left2, d.w, unsure);
  x.w -= l0.z * x.x + l1.y * x.y + l2 * x.z;
  const float a = x.w / p3, b = x.z / p2 - l2 * a, c = x.y / p1 - l1.x * b - l1.y * a;
  return vec4(x.x / p0 - l0.x * c - l0.y * b - l0.z * a, c, b, a);
}

// The roots of y^3 + a.x y^2 + a.y y + a.z, all of them real: three cosines.
vec3 cubic_roots(vec3 a) {
  const float shift = a.x / 3.0, p = shift * shift - a.y / 3.0;
  const float q = -0.5 * (shift * (2.0 * shift * shift - a.y) + a.z);
  const float angle = atan(sqrt(max(p * p * p - q * q, 0.0)), q) / 3.0;
  return 2.0 * sqrt(max(p, 0.0)) * cos(angle - vec3(0.0, 2.0, 4.0) * (kPi / 3.0)) - shift;
}

// The roots of y^4 + a.x y^3 + a.y y^2 + a.z y + a.w, all of them real: half sums of what Euler's resolvent has the squares of.
vec4 quartic_roots(vec4 a) {
  const float h = 0.25 * a.x, hh = h * h;
  const float p = a.y - 6.0 * hh, q = a.z - 2.0 * a.y * h + 8.0 * h * hh, r = a.w - a.z * h + a.y * hh - 3.0 * hh * hh;
  vec3 u = sqrt(max(cubic_roots(vec3(2.0 * p, p * p - 4.0 * r, -q * q)), vec3(0.0)));
  if (q > 0.0) u.z = -u.z;   // the product of the three is -q
  return 0.5 * vec4(u.x + u.y + u.z, u.x - u.y - u.z, u.y - u.x - u.z, u.z - u.x - u.y) - h;
}

// 0 where the denominator is.
vec4 divided(vec4 by, vec4 of) { return mix(of / by, vec4(0.0), equal(by, vec4(0.0))); }
float divided(float by, float of) { return by != 0.0 ? of / by : 0.0; }

// Those of q(y), refined by one step of Weierstrass: all at once, so that no two of them run into one.
vec4 roots(vec4 a) {
  if (kNodes == 2u) {
    const float h = -0.5 * a.x, spread = sqrt(max(h * h - a.y, 0.0)), larger = h < 0.0 ? h - spread : h + spread;
    return vec4(larger, divided(larger, a.y), 0.0, 0.0);
  }
  if (kNodes == 3u) {
    const vec3 y = cubic_roots(a.xyz);
    const vec3 value = ((y + a.x) * y + a.y) * y + a.z, apart = (y - y.yzx) * (y - y.zxy);
    return vec4(y, 0.0) - divided(vec4(apart, 0.0), vec4(value, 0.0));
  }
  const vec4 y = quartic_roots(a);
  const vec4 value = (((y + a.x) * y + a.y) * y + a.z) * y + a.w, apart = (y - y.yzwx) * (y - y.zwxy) * (y - y.wxyz);
  return y - divided(apart, value);
}

// 1 where the place of a root is in front of the depth asked about, 0 where it is behind. On the circle "in front" ends somewhere in
// the zone that no fragment is in, where it rises evenly, as published.
vec4 in_front(vec4 y, float p) {
  if (kPower) return vec4(lessThan(y, vec4(0.0)));
  const vec4 angle = p + 2.0 * atan(vec4(1.0), y);
  return mix(clamp((angle - 2.0 * kPi) / kWrappingZone + 1.0, 0.0, 1.0), vec4(1.0), greaterThanEqual(angle, vec4(2.0 * kPi)));
}

// What the interpolating function is multiplied by, so that it is within the span of the moments.
vec4 scale_of(vec4 y) {
  const vec4 square = kPower ? y * y : 1.0 + y * y;
  if (kNodes == 2u) return square;
  return square * (kNodes == 3u && kPower ? y : square);
}

// Mean of the polynomial in y that has these values at these places, by Newton's divided differences.
float mean_of_interpolation(vec4 y, vec4 v, vec4 means) {
  const vec3 first = vec3(divided(y.y - y.x, v.y - v.x), kNodes > 2u ? divided(y.z - y.y, v.z - v.y) : 0.0, kNodes > 3u ? divided(y.w - y.z, v.w - v.z) : 0.0);
  const vec3 after1 = means.yzw - y.x * means.xyz;
  float mean = v.x * means.x + first.x * after1.x;
  if (kNodes == 2u) return mean;
  const vec2 second = vec2(divided(y.z - y.x, first.y - first.x), kNodes > 3u ? divided(y.w - y.y, first.z - first.y) : 0.0);
  const vec2 after2 = after1.yz - y.y * after1.xy;
  mean += second.x * after2.x;
  if (kNodes == 3u) return mean;
  return mean + divided(y.w - y.x, second.y - second.x) * (after2.y - y.z * after2.x);
}

// Share of all absorbance that lies in front of warped depth w; of what lies there itself, kOverestimation. `low` and `high` are the
// moments divided by b0.
float share_in_front(vec4 low, vec4 high, float w, out bool unsure) {
  const float p = kPower ? 0.0 : phase_of(w);
  Seen seen;
  if (kPower) {
    const vec4 wide_low = kNodes == 2u ? vec4(0.0, 0.375, 0.0, 0.375) : kNodes == 3u ? vec4(0.0, 0.48, 0.0, 0.451) : vec4(0.0, 0.75, 0.0, 0.67667);
    const vec4 wide_high = kNodes == 3u ? vec4(0.0, 0.45, 0.0, 0.0) : vec4(0.0, 0.63, 0.0, 0.60030);
    seen = seen_from_depth(mix(low, wide_low, kBias), mix(high, wide_high, kBias), w);
  } else {
    seen = seen_from_phase(low * (1.0 - kBias), high * (1.0 - kBias), p);   // evenly around the circle
  }
  const vec4 y = roots(solve(seen, unsure));
  const float share = kOverestimation + mean_of_interpolation(y, (in_front(y, p) - kOverestimation) * scale_of(y), seen.means);
  if (isnan(share) || isinf(share)) {   // as if everything were in one place, that of the fragment itself
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
