// Stochastic transparency: the share of a pixel's samples that nothing covered in front of a depth. Its expectation is the
// transmittance there. A fragment is not behind itself, so its own samples count as free.
#ifndef PLUME_STOCHASTIC_VISIBLE_GLSL
#define PLUME_STOCHASTIC_VISIBLE_GLSL

layout(constant_id = 0) const uint kRounds = 1u;
layout(binding = 10, rgba32f) readonly uniform image2DArray kept;

float visible_at(ivec2 pixel, float window_depth) {   // reversed: nearer is greater
  const vec4 own = vec4(window_depth);
  vec4 seen = vec4(0.0);
  for (uint i = 0u; i < kRounds; ++i)
    seen += mix(vec4(0.0), vec4(1.0), lessThanEqual(imageLoad(kept, ivec3(pixel, i)), own));
  return dot(seen, vec4(0.25)) / float(kRounds);
}

#endif
