// The weight of "Fast Colored Transparency" (2015), of the window depth d of a conventional projection and the reduced coverage a:
//   w = clamp(1000 ((8 a + 0.01) (1 - 0.95 d))^3, 0.01, 300),   the cubed term over sqrt(z) where the scene is far away.
// Nearly all of a scene lies at d near 1: kNearScale moves the near plane that d is made with, and nothing else.
#ifndef PLUME_COLOURED_WEIGHT_GLSL
#define PLUME_COLOURED_WEIGHT_GLSL

layout(constant_id = 0) const uint kFarScene = 0u;
layout(constant_id = 1) const float kNearScale = 1.0;

#include "methods/parts/weighted/window_depth.glsl"

float weight(float depth, float alpha) {
  float term = (alpha * 8.0 + 0.01) * (1.0 - 0.95 * window_depth(depth, kNearScale));
  if (kFarScene != 0u) term /= sqrt(depth);
  return clamp(term * term * term * 1e3, 1e-2, 3e2);
}

#endif
