// The published weights of WBOIT: guesses from depth and opacity of how much of a fragment is seen. McGuire and Bavoil, JCGT 2(2),
// 2013, equations 7 to 10; their blog's colour-aware factor (2013); LearnOpenGL's demo (2020).
#ifndef PLUME_WBOIT_WEIGHT_GLSL
#define PLUME_WBOIT_WEIGHT_GLSL

layout(constant_id = 0) const uint kWeight = 0;
layout(constant_id = 1) const float kDepthScale = 1.0;   // paper's units per metre

#include "methods/parts/weighted/window_depth.glsl"

float eq9_depth(float z) { return clamp(0.03 / (1e-5 + pow(z / 200.0, 4.0)), 1e-2, 3e3); }

// `light` is premultiplied.
float weight(float depth, float alpha, vec3 light) {
  const float z = depth * kDepthScale;
  const float window = window_depth(depth, 1.0);   // equation 10 and the demo
  switch (kWeight) {
    case 0u: return alpha * clamp(10.0 / (1e-5 + pow(z / 5.0, 2.0) + pow(z / 200.0, 6.0)), 1e-2, 3e3);
    case 1u: return alpha * clamp(10.0 / (1e-5 + pow(z / 10.0, 3.0) + pow(z / 200.0, 6.0)), 1e-2, 3e3);
    case 2u: return alpha * eq9_depth(z);
    case 3u: return alpha * max(1e-2, 3e3 * pow(max(1.0 - window, 0.0), 3.0));
    case 4u: return max(min(1.0, max(light.r, max(light.g, light.b))), alpha) * eq9_depth(z);
    default: {
      const float opacity = min(1.0, alpha * 10.0) + 0.01, near = max(1.0 - window * 0.9, 0.0);
      return clamp(opacity * opacity * opacity * 1e8 * near * near * near, 1e-2, 3e3);
    }
  }
}

#endif
