// Stochastic transparency: the share of a pixel's samples that nothing covered in front of a depth. Its expectation is the
// transmittance there. A fragment is not behind itself, so its own samples count as free.
#ifndef PLUME_STOCHASTIC_VISIBLE_GLSL
#define PLUME_STOCHASTIC_VISIBLE_GLSL

layout(constant_id = 0) const uint kRounds = 1u;
layout(binding = 10, rgba32f) readonly uniform image2DArray kept;

const float kRounding = 1.0 + 1e-5;   // of the depths of a steep card, from one draw to the other

float visible_at(ivec2 pixel, float depth) {
  const vec4 own = vec4(view.near_m / depth * kRounding);   // reversed: nearer is greater
  vec4 seen = vec4(0.0);
  for (uint i = 0u; i < kRounds; ++i)
    seen += mix(vec4(0.0), vec4(1.0), lessThanEqual(imageLoad(kept, ivec3(pixel, i)), own));
  return dot(seen, vec4(0.25)) / float(kRounds);
}

#endif
