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
//   w_j = 1 / sum_i |p_i(x_j)|^2 with orthonormal polynomials p_i (Christoffel): sums of squares, so that all shares are positive
//   whatever is rounded, where interpolation between places that nearly coincide loses every digit.
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

// Written out, because arrays indexed in loops are slow where a compiler leaves them in memory; what a kind has no use for is not
// computed.
struct Seen {
  float all;   // s_0
  vec4 near;   // s_1 .. s_4
  vec4 far;    // s_5 .. s_8
};

// By one factor x - w after the other: binomial coefficients would take two more digits.
Seen seen_from_depth(vec4 b, vec4 c, float w) {   // b: moments 1 to 4, c: 5 to 8
  Seen s = Seen(1.0, b, c);
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
  return s;
}

Seen seen_from_phase(vec4 b, vec4 c, float p) {
  const vec2 once = vec2(cos(p), -sin(p)), twice = turn(once, once);
  const vec2 e = turn(b.xy, once), f = turn(b.zw, twice);   // means of (cos, sin) of the angle from p, and of twice that
  Seen s;
  if (kNodes == 2u) {
    s.all = (3.0 + 4.0 * e.x + f.x) / 8.0;
    s.near = vec4(2.0 * e.y + f.y, 1.0 - f.x, 2.0 * e.y - f.y, 3.0 - 4.0 * e.x + f.x) / 8.0;
    s.far = vec4(0.0);
    return s;
  }
  const vec2 g = turn(c.xy, turn(twice, once));
  if (kNodes == 3u) {
    s.all = (10.0 + 15.0 * e.x + 6.0 * f.x + g.x) / 32.0;
    s.near = vec4(5.0 * e.y + 4.0 * f.y + g.y, 2.0 + e.x - 2.0 * f.x - g.x, 3.0 * e.y - g.y, 2.0 - e.x - 2.0 * f.x + g.x) / 32.0;
    s.far = vec4(5.0 * e.y - 4.0 * f.y + g.y, 10.0 - 15.0 * e.x + 6.0 * f.x - g.x, 0.0, 0.0) / 32.0;
  } else {
    const vec2 h = turn(c.zw, turn(twice, twice));
    s.all = (35.0 + 56.0 * e.x + 28.0 * f.x + 8.0 * g.x + h.x) / 128.0;
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

// The matrix s_(k+j) as L D L^T: Cholesky's decomposition without roots.
struct Factors {
  vec4 pivot;
  vec3 l0;    // below the diagonal of L's first column
  vec2 l1;
  float l2;
};

Factors factors_of(Seen s, out bool unsure) {
  unsure = false;
  const vec4 d = vec4(s.near.y, s.near.w, s.far.y, s.far.w);   // the diagonal
  Factors f = Factors(vec4(1.0), vec3(0.0), vec2(0.0), 0.0);
  f.pivot.x = kept_up(d.x, d.x, unsure);
  f.l0 = vec3(s.near.zw, s.far.x) / f.pivot.x;
  f.pivot.y = kept_up(d.y - f.l0.x * s.near.z, d.y, unsure);
  if (kNodes == 2u) return f;
  const vec2 left1 = s.far.xy - f.l0.yz * s.near.z;
  f.l1 = left1 / f.pivot.y;
  f.pivot.z = kept_up(d.z - f.l0.y * s.near.w - f.l1.x * left1.x, d.z, unsure);
  if (kNodes == 3u) return f;
  const float left2 = s.far.z - f.l0.z * s.near.w - f.l1.y * left1.x;
  f.l2 = left2 / f.pivot.z;
  f.pivot.w = kept_up(d.w - f.l0.z * s.far.x - f.l1.y * left1.y - f.l2 * left2, d.w, unsure);
  return f;
}

// Coefficients a_1 .. a_n of q(y).
vec4 solve(Seen s, Factors f) {
  vec4 x = -s.near;
  x.y -= f.l0.x * x.x;
  if (kNodes == 2u) {
    const float a = x.y / f.pivot.y;
    return vec4(x.x / f.pivot.x - f.l0.x * a, a, 0.0, 0.0);
  }
  x.z -= f.l0.y * x.x + f.l1.x * x.y;
  if (kNodes == 3u) {
    const float a = x.z / f.pivot.z, b = x.y / f.pivot.y - f.l1.x * a;
    return vec4(x.x / f.pivot.x - f.l0.x * b - f.l0.y * a, b, a, 0.0);
  }
  x.w -= f.l0.z * x.x + f.l1.y * x.y + f.l2 * x.z;
  const float a = x.w / f.pivot.w, b = x.z / f.pivot.z - f.l2 * a, c = x.y / f.pivot.y - f.l1.x * b - f.l1.y * a;
  return vec4(x.x / f.pivot.x - f.l0.x * c - f.l0.y * b - f.l0.z * a, c, b, a);
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

// A step of Weierstrass towards the roots: all at once, so that no two of them run into one. Where two already are, nothing is done.
vec4 refined(vec4 y, vec4 a) {
  const vec4 value = kNodes == 3u ? ((y + a.x) * y + a.y) * y + a.z : (((y + a.x) * y + a.y) * y + a.z) * y + a.w;
  const vec4 apart = kNodes == 3u ? vec4((y.xyz - y.yzx) * (y.xyz - y.zxy), 1.0) : (y - y.yzwx) * (y - y.zwxy) * (y - y.wxyz);
  return y - mix(value / apart, vec4(0.0), equal(apart, vec4(0.0)));
}

// Those of q(y); a second step, because the quartic's first guess loses half of its digits where one root is far larger than the rest.
vec4 roots(vec4 a) {
  if (kNodes == 2u) {
    const float h = -0.5 * a.x, spread = sqrt(max(h * h - a.y, 0.0)), larger = h < 0.0 ? h - spread : h + spread;
    return vec4(larger, larger != 0.0 ? a.y / larger : 0.0, 0.0, 0.0);
  }
  const vec4 y = kNodes == 3u ? vec4(cubic_roots(a.xyz), 0.0) : quartic_roots(a);
  return refined(refined(y, a), a);
}

// 1 where the place of a root is in front of the depth asked about, 0 where it is behind. On the circle "in front" ends somewhere in
// the zone that no fragment is in, where it rises evenly, as published.
vec4 in_front(vec4 y, float p) {
  if (kPower) return vec4(lessThan(y, vec4(0.0)));
  const vec4 angle = p + 2.0 * atan(vec4(1.0), y);
  return mix(clamp((angle - 2.0 * kPi) / kWrappingZone + 1.0, 0.0, 1.0), vec4(1.0), greaterThanEqual(angle, vec4(2.0 * kPi)));
}

// Shares of absorbance at the places of the roots: 1 / (e^T (L D L^T)^-1 e) with e = (y^(n-1), .., y, 1), scaled.
vec4 shares(Factors f, vec4 y) {
  const vec4 square = 1.0 + y * y, one = inversesqrt(square), c = y * one;   // (c, one): y as a direction
  const vec4 top = kNodes == 2u ? c : kNodes == 3u ? c * c : c * c * c;
  const vec4 t1 = (kNodes == 2u ? one : kNodes == 3u ? c * one : c * c * one) - f.l0.x * top;
  vec4 sum = top * top / f.pivot.x + t1 * t1 / f.pivot.y;
  if (kNodes > 2u) {
    const vec4 t2 = (kNodes == 3u ? one * one : c * one * one) - f.l0.y * top - f.l1.x * t1;
    sum += t2 * t2 / f.pivot.z;
    if (kNodes > 3u) {
      const vec4 t3 = one * one * one - f.l0.z * top - f.l1.y * t1 - f.l2 * t2;
      sum += t3 * t3 / f.pivot.w;
    }
  }
  const vec4 scale = kPower ? top * y * (top * y) : square;
  return scale / sum * vec4(1.0, 1.0, kNodes > 2u ? 1.0 : 0.0, kNodes > 3u ? 1.0 : 0.0);
}

// Share of all absorbance that lies in front of warped depth w; of what lies there itself, kOverestimation. `low` and `high` are the
// moments divided by b0.
float share_in_front(vec4 low, vec4 high, float w, out bool unsure) {
  const float p = kPower ? 0.0 : phase_of(w);
  Seen seen;
  if (kPower) {
    const vec4 wide_low = kNodes == 2u   ? vec4(0.0, 0.375, 0.0, 0.375)
                          : kNodes == 3u ? vec4(0.0, 0.48, 0.0, 0.451)
                                         : vec4(0.0, 0.75, 0.0, 0.67667);
    const vec4 wide_high = kNodes == 3u ? vec4(0.0, 0.45, 0.0, 0.0) : vec4(0.0, 0.63, 0.0, 0.60030);
    seen = seen_from_depth(mix(low, wide_low, kBias), mix(high, wide_high, kBias), w);
  } else {
    seen = seen_from_phase(low * (1.0 - kBias), high * (1.0 - kBias), p);   // evenly around the circle
  }
  const Factors factors = factors_of(seen, unsure);
  const vec4 a = solve(seen, factors), y = roots(a), w_j = shares(factors, y);
  const float w_0 = clamp(seen.all + dot(a, seen.near), 0.0, 1.0);
  const float share = (dot(w_j, in_front(y, p)) + kOverestimation * w_0) / (dot(w_j, vec4(1.0)) + w_0);
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
