// The weight of phenomenological transparency (2016), of the window depth d of a conventional projection and the reduced coverage a:
//   w = clamp(1000 a (1 - 0.99 d)^3, 0.01, 30),   the cubed term over sqrt(z) where the scene is far away.
// Nearly all of a scene lies at d near 1: kNearScale moves the near plane that d is made with, and nothing else.
#ifndef PLUME_PHENOMENOLOGICAL_WEIGHT_GLSL
#define PLUME_PHENOMENOLOGICAL_WEIGHT_GLSL

layout(constant_id = 0) const uint kFarScene = 0u;
layout(constant_id = 1) const float kNearScale = 1.0;

#include "methods/parts/weighted/window_depth.glsl"

float weight(float depth, float alpha) {
  float term = 1.0 - 0.99 * window_depth(depth, kNearScale);
  if (kFarScene != 0u) term /= sqrt(depth);
  return clamp(alpha * term * term * term * 1e3, 1e-2, 30.0);
}

#endif
