// Divergence-free noise for turbulence: the cross product of the gradients of two scalar noises has no divergence (DeWolf,
// "Divergence-Free Noise", 2005), and needs two gradients where a vector potential needs three. Both noises share their lattice hashes.
#ifndef PLUME_EFFECTS_NOISE_GLSL
#define PLUME_EFFECTS_NOISE_GLSL
#include "shared/hash.h"

// Two values in [-1, 1] for a lattice point.
vec2 lattice(uvec3 p) {
  uint h = p.x * 0x8da6b343u ^ p.y * 0xd8163841u ^ p.z * 0xcb1ab31fu;
  h ^= h >> 15u;
  h *= 0x2c1b3c6du;
  h ^= h >> 13u;
  return vec2(float(h & 0xffffu), float(h >> 16u)) * (2.0 / 65535.0) - 1.0;
}

// Velocity-like vector of zero divergence and magnitude about 1, from quintic value noise.
vec3 curl_noise(vec3 position) {
  precise vec3 base = floor(position);
  precise vec3 f = position - base;
  precise vec3 u = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
  precise vec3 du = 30.0 * f * f * (f * (f - 2.0) + 1.0);
  const uvec3 p = uvec3(ivec3(base));
  const vec2 a = lattice(p), b = lattice(p + uvec3(1, 0, 0)), c = lattice(p + uvec3(0, 1, 0));
  const vec2 d = lattice(p + uvec3(1, 1, 0)), e = lattice(p + uvec3(0, 0, 1)), g = lattice(p + uvec3(1, 0, 1));
  const vec2 h = lattice(p + uvec3(0, 1, 1)), k = lattice(p + uvec3(1, 1, 1));
  // Coefficients of the trilinear form in u, for both noises at once.
  const vec2 k1 = b - a, k2 = c - a, k3 = e - a;
  const vec2 k4 = a - b - c + d, k5 = a - c - e + h, k6 = a - b - e + g, k7 = b + c + e + k - a - d - g - h;
  precise vec2 dx = du.x * (k1 + k4 * u.y + k6 * u.z + k7 * u.y * u.z);
  precise vec2 dy = du.y * (k2 + k5 * u.z + k4 * u.x + k7 * u.z * u.x);
  precise vec2 dz = du.z * (k3 + k6 * u.x + k5 * u.y + k7 * u.x * u.y);
  precise vec3 result = cross(vec3(dx.x, dy.x, dz.x), vec3(dx.y, dy.y, dz.y));
  return result;
}

// Octaves of it at `arm` from a centre, each half as strong and about twice as fine as the one before. `drift` is how many
// wavelengths the field has risen; the seed tells fields apart.
vec3 turbulence(uint seed, vec3 arm, float inv_scale, float drift, float strength, uint octaves) {
  precise vec3 at = arm * inv_scale;
  at.y -= drift;
  at += vec3(seed & 0xffu, (seed >> 8u) & 0xffu, (seed >> 16u) & 0xffu);
  precise vec3 sum = vec3(0.0);
  precise float weight = strength;
  for (uint octave = 0u; octave < octaves; ++octave) {
    sum += weight * curl_noise(at);
    at = at * 2.03 + 17.3;
    weight *= 0.5;
  }
  return sum;
}

#endif
