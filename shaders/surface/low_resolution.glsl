// Things drawn with fewer pixels than the picture has, beside others at its own resolution: the depth they are tested against, and
// how their sums are read for a pixel of the picture. Depths are reversed.
#ifndef PLUME_SURFACE_LOW_RESOLUTION_GLSL
#define PLUME_SURFACE_LOW_RESOLUTION_GLSL

// Of divisor x divisor pixels: nothing that one of them sees is missing.
float farthest_depth(sampler2D depth, ivec2 at, int divisor) {
  const ivec2 last = textureSize(depth, 0) - 1;
  float farthest = 1.0;
  for (int i = 0; i < divisor * divisor; ++i)
    farthest = min(farthest, texelFetch(depth, min(at * divisor + ivec2(i % divisor, i / divisor), last), 0).r);
  return farthest;
}

// One of the four texels around a pixel, weighted bilinearly, and the less the more its depth differs from the pixel's: no halo at
// the edges of opaque things. The four weights do not sum to one.
struct LowTap {
  ivec2 at;
  float weight;
};

LowTap low_tap(sampler2D low_depth, ivec2 pixel, uint divisor, float depth_here, int i) {
  const vec2 place = (vec2(pixel) + 0.5) / float(divisor) - 0.5, part = fract(place);
  const ivec2 step = ivec2(i & 1, i >> 1), at = clamp(ivec2(floor(place)) + step, ivec2(0), textureSize(low_depth, 0) - 1);
  const vec2 near = mix(1.0 - part, part, vec2(step));
  const float there = texelFetch(low_depth, at, 0).r;
  return LowTap(at, near.x * near.y / (0.02 + abs(there - depth_here) / max(max(there, depth_here), 1e-9)));
}

#endif
