// AVBOIT's transmittance at a depth: the integral, filtered bilinearly across cells and by kSampling along the ray.
// Biased samplings (the talk) read the transmittance `bias` slices in front of the fragment, so that it does not occlude itself,
// and so miss what stands in those slices. Self-excluded sampling reads the optical depth at the fragment and takes out the
// fragment's own share, which it knows from its own optical depth and place in its slice.
#ifndef PLUME_AVBOIT_TRANSMITTANCE_GLSL
#define PLUME_AVBOIT_TRANSMITTANCE_GLSL
#include "methods/avboit/depth_warp.glsl"

layout(constant_id = 0) const uint kSampling = 4u;   // 0 point, 1 linear, 2 quadratic, 3 cubic, 4 self-excluded
layout(constant_id = 1) const uint kRgb = 1u;        // RGB sources have an integral of their own
layout(constant_id = 2) const uint kLinear = 1u;     // how the splat shared optical depth
layout(scalar, binding = 10) readonly buffer Integral { uint integral[]; };
layout(scalar, binding = 11) readonly buffer IntegralRgb { uint integral_rgb[]; };
layout(scalar, binding = 12) readonly buffer RgbStart { uint rgb_start[]; };

struct Footprint {
  uvec4 rays;
  vec4 weights;
  float slice;   // where along the ray the integral is read
  float share;   // of the fragment's own optical depth that lies in front of that place
};

Footprint footprint(vec2 pixel, float depth) {
  Footprint f;
  const vec2 at = pixel / float(volume.divisor) - 0.5;
  const vec2 low = floor(at), part = at - low;
  const ivec2 last = ivec2(volume.cells) - 1;
  const uvec2 a = uvec2(clamp(ivec2(low), ivec2(0), last)), b = uvec2(clamp(ivec2(low) + 1, ivec2(0), last));
  f.rays = uvec4(a.y, a.y, b.y, b.y) * volume.cells.x + uvec4(a.x, b.x, a.x, b.x);
  f.weights = vec4((1.0 - part.x) * (1.0 - part.y), part.x * (1.0 - part.y), (1.0 - part.x) * part.y, part.x * part.y);
  const float p = slice_at(depth), g = fract(p);
  f.share = 0.0;
  if (kSampling == 4u) {
    // A slice's optical depth is spread over it, so what was splatted at p lies around p + 1/2: that is where to read.
    f.slice = kLinear != 0u ? p + 0.5 : p;
    f.share = kLinear != 0u ? (1.0 - g) * min(g + 0.5, 1.0) + g * max(g - 0.5, 0.0) : g;
  } else {
    f.slice = max((kSampling == 0u ? floor(p) : p + 1.0) - volume.bias, 0.0);
  }
  return f;
}

// Nodes in front of and behind a slice, averaged over the footprint.
vec2 pair_at(Footprint f, uint slice) {
  const uint base = slice * volume.cells.x * volume.cells.y;
  vec2 sum = vec2(0.0);
  for (uint i = 0u; i < 4u; ++i) sum += f.weights[i] * unpackHalf2x16(integral[base + f.rays[i]]);
  return sum;
}

vec2 rgb_pair_at(Footprint f, uint slice, uint channel) {
  const uint base = slice * volume.cells.x * volume.cells.y;
  vec2 sum = vec2(0.0);
  for (uint i = 0u; i < 4u; ++i) sum += f.weights[i] * unpackHalf2x16(integral_rgb[(base + f.rays[i]) * 3u + channel]);
  return sum;
}

// Weights of the nodes around a place between two of them, `part` of the way: B-splines of degree 2 and 3.
vec4 spline(float part) {
  if (kSampling == 2u) {
    const float t = part < 0.5 ? part + 0.5 : part - 0.5;
    const vec3 w = vec3(0.5 * (1.0 - t) * (1.0 - t), 0.5 + t * (1.0 - t), 0.5 * t * t);
    return part < 0.5 ? vec4(w, 0.0) : vec4(0.0, w);
  }
  const float s = 1.0 - part;
  return vec4(s * s * s, 4.0 - 6.0 * part * part + 3.0 * part * part * part, 4.0 - 6.0 * s * s + 3.0 * s * s * s, part * part * part) / 6.0;
}

float value_at(Footprint f) {
  const uint slice = min(uint(f.slice), volume.slices - 1u);
  const float part = min(f.slice - float(slice), 1.0);
  const vec2 here = pair_at(f, slice);
  if (kSampling == 0u) return here.x;
  if (kSampling == 1u || kSampling == 4u) return mix(here.x, here.y, part);
  const vec4 w = spline(part);
  const float before = pair_at(f, slice - min(slice, 1u)).x, behind = pair_at(f, min(slice + 1u, volume.slices - 1u)).y;
  return dot(w, vec4(before, here, behind));
}

vec3 rgb_value_at(Footprint f) {
  const uint slice = min(uint(f.slice), volume.slices - 1u);
  const float part = min(f.slice - float(slice), 1.0);
  vec3 value;
  for (uint c = 0u; c < 3u; ++c) {
    const vec2 here = rgb_pair_at(f, slice, c);
    if (kSampling == 0u) value[c] = here.x;
    else if (kSampling == 1u || kSampling == 4u) value[c] = mix(here.x, here.y, part);
    else {
      const vec4 w = spline(part);
      const float before = rgb_pair_at(f, slice - min(slice, 1u), c).x, behind = rgb_pair_at(f, min(slice + 1u, volume.slices - 1u), c).y;
      value[c] = dot(w, vec4(before, here, behind));
    }
  }
  return value;
}

bool rgb_in_front(vec2 pixel, Footprint f) {
  const uvec2 tile = uvec2(pixel) / (volume.divisor * kTileCells);
  return uint(f.slice) >= rgb_start[tile.y * volume.tiles.x + tile.x];
}

// `own` is the optical depth of the fragment itself, and in which integral it was splatted.
vec3 transmittance_at(vec2 pixel, float depth, float own, vec3 own_rgb) {
  const Footprint f = footprint(pixel, depth);
  const float value = value_at(f);
  vec3 t = vec3(kSampling == 4u ? exp(-max(value - own * f.share, 0.0)) : value);
  // A loop, because CPU devices run both sides of a condition: away from coloured glass nothing is read.
  const uint times = kRgb != 0u && rgb_in_front(pixel, f) ? 1u : 0u;
  for (uint i = 0u; i < times; ++i) {
    const vec3 rgb = rgb_value_at(f);
    t *= kSampling == 4u ? exp(-max(rgb - own_rgb * f.share, vec3(0.0))) : rgb;
  }
  return t;
}
#endif
