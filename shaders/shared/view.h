// One camera at one tick, and the light, as every shader sees them.
#ifndef PLUME_SHARED_VIEW_H
#define PLUME_SHARED_VIEW_H

#include "shared/types.h"

PLUME_SHARED_BEGIN

struct ViewData {
  mat4 view_projection;  // reversed depth, infinite far plane: clip z / w = near_m / view depth
  vec3 camera;           // world position
  float near_m;
  vec3 right;
  float far_m;  // where depth curves end; nothing is clipped there
  vec3 up;
  float exposure;
  vec3 forward;
  uint tick;
  vec2 tan_half_fov;   // x, y
  uvec2 size;          // pixels
  vec3 sun_direction;  // towards the sun, unit length
  uint sky;            // 0: the background is `horizon` everywhere
  vec3 sun_color;      // irradiance / pi
  uint tonemap;        // 0 none, 1 ACES
  vec3 zenith;
  uint solid_count;
  vec3 horizon;
  uint padding;
  mat4 previous_view_projection;  // of the tick before
};

PLUME_SHARED_END
#endif
