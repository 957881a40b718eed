// AVBOIT's transmittance in front of a fragment: the integral, filtered bilinearly across cells and by kSampling along the ray.
// Biased samplings (the talk) read the transmittance `bias` slices in front of the fragment, so that it does not occlude itself,
// and so miss what stands in those slices. Self-excluded sampling reads the optical depth at the fragment and takes out the
// fragment's own share, which it knows from its own optical depth and place in its slice. It also tells how far it is in doubt.
#ifndef PLUME_AVBOIT_TRANSMITTANCE_GLSL
#define PLUME_AVBOIT_TRANSMITTANCE_GLSL
#include "methods/avboit/depth_warp.glsl"
#include "methods/avboit/exact_layers.h"
#include "methods/avboit/fields.glsl"

layout(constant_id = 0) const uint kSampling = 4u;   // 0 point, 1 linear, 2 quadratic, 3 cubic, 4 self-excluded
layout(constant_id = 1) const uint kLinear = 1u;     // how the splat shared optical depth
layout(constant_id = 2) const uint kRgb = 0u;        // read each channel
layout(constant_id = 8) const uint kLaneBits = 16u;  // of the fields that the fragment's own optical depth went into
layout(binding = 10) uniform sampler2DArray integral;      // (before, behind) each slice
layout(binding = 11) uniform sampler2DArray integral_rg;   // (r before, r behind, g before, g behind)
layout(binding = 12) uniform sampler2DArray integral_b;
layout(scalar, binding = 13) readonly buffer Layers { uvec2 layers[]; };   // [layer][pixel]: (transmittance, place)
layout(scalar, binding = 14) readonly buffer LayerTails { uint merged; LayerTail tails[]; };

// Nodes in front of and behind a slice, a row a channel.
mat3x2 nodes_of(vec2 uv, uint slice) {
  const vec3 at = vec3(uv, float(slice));
  if (kRgb == 0u) return mat3x2(textureLod(integral, at, 0.0).rg, vec2(0.0), vec2(0.0));
  const vec4 rg = textureLod(integral_rg, at, 0.0);
  return mat3x2(rg.rg, rg.ba, textureLod(integral_b, at, 0.0).rg);
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

vec3 value_at(vec2 uv, float place) {
  const uint slice = min(uint(max(place, 0.0)), volume.slices - 1u);
  const float part = clamp(place - float(slice), 0.0, 1.0);
  const mat3x2 here = nodes_of(uv, slice);
  if (kSampling == 0u) return vec3(here[0].x, here[1].x, here[2].x);
  if (kSampling == 1u || kSampling == 4u) return vec2(1.0 - part, part) * here;
  const vec4 w = spline(part);
  const mat3x2 before = nodes_of(uv, slice - min(slice, 1u)), behind = nodes_of(uv, min(slice + 1u, volume.slices - 1u));
  return vec3(w.x * before[0].x, w.x * before[1].x, w.x * before[2].x) + w.yz * here + vec3(w.w * behind[0].y, w.w * behind[1].y, w.w * behind[2].y);
}

// How much of the tail's optical depth lies in front of a depth: a power of the place between its nearest and its farthest, the one
// that gives the mean of what fell into it.
float tail_in_front(LayerTail tail, float depth) {
  const float nearest = tail_place(uintBitsToFloat(~tail.before)), farthest = tail_place(uintBitsToFloat(tail.farthest));
  const float whole = (float(tail.depth.r) + float(tail.depth.g) + float(tail.depth.b)) / 3.0, length = max(farthest - nearest, 1e-9);
  const float mean = clamp((float(tail.places) / max(whole, 1.0) - nearest) / length, 0.1, 0.9);
  return pow(clamp((tail_place(depth) - nearest) / length, 0.0, 1.0), mean / (1.0 - mean));
}

// What a fragment of optical depth `own`, 0 for what is not a part of it, is seen through in the tail. Where all of the tail stands in one
// place, each covers in proportion to its optical depth, and together 1 - exp(-whole); otherwise half of its own counts in front of it.
vec3 tail_transmittance(LayerTail tail, float depth, vec3 own) {
  const vec3 whole = vec3(tail.depth) / kTailSteps;
  const bool in_one_place = ~tail.before == tail.farthest, outside = own == vec3(0.0);
  if (in_one_place && !outside) {
    const vec3 part = max(own, vec3(1e-4)), all = max(whole, part);
    return (1.0 - exp(-all)) * part / (all * (1.0 - exp(-part)));
  }
  return exp(-max(tail_in_front(tail, depth) * whole - 0.5 * own, 0.0));
}

// What the exact layers in front of a fragment of card `id` leave; `own` is its optical depth if it is sharp, or 0. Tells whether it may
// itself be in the tail, so that its weight is an estimate.
vec3 layers_in_front(uvec2 pixel, float depth, uint id, vec3 own, out bool estimated) {
  vec3 t = vec3(1.0);
  const uint plane = view.size.x * view.size.y, first = pixel.y * view.size.x + pixel.x;
  uint k = 0u;
  for (; k < volume.exact_layers; ++k) {
    const uvec2 layer = layers[k * plane + first];
    if (!layer_in_front(layer.y, depth, id)) break;
    t *= unpack_layer(layer.x);
  }
  estimated = k > 0u && k == volume.exact_layers && tails[first].before != 0u;
  return estimated ? t * tail_transmittance(tails[first], depth, own) : t;
}

// Where along the ray the integral is read for a fragment whose place is p, both in slices. A slice's optical depth is spread over it, so
// what was splatted linearly at p lies around p + 1/2.
float reading_place(float p) {
  if (kSampling == 4u) return kLinear != 0u ? p + 0.5 : p;
  return (kSampling == 0u ? floor(p) : p + 1.0) - volume.bias;
}

// The four cells around a pixel, and its weights of them. From the middle of the outermost cells to the picture's border values go on
// as they came.
struct Around {
  vec2 uv;        // where all four meet
  vec4 weights;   // in the order of textureGather
};

Around cells_around(vec2 pixel) {
  const vec2 at = pixel / float(volume.divisor) - 0.5, first = clamp(floor(at), vec2(0.0), max(vec2(volume.cells) - 2.0, 0.0)), part = at - first;
  return Around((first + 1.0) / vec2(volume.cells), vec4((1.0 - part.x) * part.y, part.x * part.y, part.x * (1.0 - part.y), (1.0 - part.x) * (1.0 - part.y)));
}

// A channel's nodes in front of the slice and behind it, in each.
mat2x4 nodes_around(Around cells, uint slice, uint channel) {
  const vec3 at = vec3(cells.uv, float(slice));
  if (kRgb == 0u) return mat2x4(textureGather(integral, at, 0), textureGather(integral, at, 1));
  if (channel == 0u) return mat2x4(textureGather(integral_rg, at, 0), textureGather(integral_rg, at, 1));
  if (channel == 1u) return mat2x4(textureGather(integral_rg, at, 2), textureGather(integral_rg, at, 3));
  return mat2x4(textureGather(integral_b, at, 0), textureGather(integral_b, at, 1));
}

float least(vec4 v) { return min(min(v.x, v.y), min(v.z, v.w)); }
float most(vec4 v) { return max(max(v.x, v.y), max(v.z, v.w)); }

// How far optical depth in front of a fragment may be off, a unit of what it is off by: between the cells around, for there an edge may
// lie; of what shares the slice, for it may stand on either side; of all that is in front; and of nothing at all, since cells miss
// things. Only their ratios matter. By measure: of 14 such sets these give the least errors over seven scenes and the hard cases.
const float kAcrossCells = 0.5, kInSlice = 2.0, kInFront = 0.1, kMissedByCells = 0.005;

struct Reading {
  vec3 transmittance;
  float doubt;   // 0: sure of it, 1: not at all
};

// `own` is the optical depth of the fragment itself, `p` its place along the ray in slices.
Reading transmittance_at(vec2 pixel, float p, vec3 own) {
  vec3 t;
  float off = kMissedByCells;
  if (kSampling == 4u) {
    // Of the slice that is read, what is not the fragment's own cannot be less than nothing, where its cell saw less of it than the
    // pixel; and where smoke ends, one cell sees more of it than the pixel does, and only what all cells see beside it is another's.
    const float g = fract(p), place = reading_place(p);
    const float most_share = min(most_depth(kLaneBits), kFullSlice);   // of a share, as it was stored and summed
    const uint slice = min(uint(place), volume.slices - 1u);
    const float part = clamp(place - float(slice), 0.0, 1.0);
    const bool in_next = kLinear != 0u && g >= 0.5;   // its first share lies in the slice in front
    const vec3 own_here = min(kLinear == 0u ? own : in_next ? own * g : own * (1.0 - g), most_share);
    const vec3 own_before = in_next ? min(own * (1.0 - g), most_share) : vec3(0.0);
    const Around cells = cells_around(pixel);
    vec3 in_front = vec3(0.0), in_slice = vec3(0.0);
    for (uint c = 0u; c < (kRgb == 0u ? 1u : 3u); ++c) {
      const mat2x4 nodes = nodes_around(cells, slice, c);
      const vec4 each_in_front = max(nodes[0] - own_before[c], 0.0);
      in_front[c] = max(dot(cells.weights, nodes[0]) - own_before[c], 0.0);
      in_slice[c] = min(max(dot(cells.weights, nodes[1] - nodes[0]) - own_here[c], 0.0), least(max(nodes[1] - nodes[0] - own_here[c], 0.0)));
      off = max(off, kMissedByCells + kAcrossCells * (most(each_in_front) - least(each_in_front)) + kInSlice * in_slice[c] + kInFront * in_front[c]);
    }
    t = exp(-in_front - part * in_slice);
  } else {
    t = value_at(pixel / vec2(volume.cells * volume.divisor), reading_place(p));
  }
  return Reading(kRgb != 0u ? t : t.rrr, kSampling == 4u ? 1.0 - exp(-off) : 1.0);
}
#endif
