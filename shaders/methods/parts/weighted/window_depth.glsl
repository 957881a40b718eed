// Window depth of a conventional projection between the near and the far plane, 0 to 1, which weights are written for: Plume's own
// depth is reversed and has no far plane.
#ifndef PLUME_WEIGHTED_WINDOW_DEPTH_GLSL
#define PLUME_WEIGHTED_WINDOW_DEPTH_GLSL

float window_depth(float depth, float near_scale) {
  const float near = min(view.near_m * near_scale, 0.5 * view.far_m);
  return max(view.far_m / (view.far_m - near) * (1.0 - near / depth), 0.0);
}

#endif
