// Distortion and surface, exactly: each pixel's sorted list is walked once more, front to back,
//   distortion = sum_i shift_i prod_{j<i} t_j,   surface = sum_i p_i (1 / z_i, 1, motion_i) prod_{j<i} t_j,
// with t the mean of the channels' transmittance so far.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_buffer_reference_uvec2 : require
#include "methods/parts/fragment_list/fragment_list.h"
#include "surface/motion.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = 0) const uint kDistortion = 1u;   // written
layout(constant_id = 1) const uint kSurface = 1u;
layout(scalar, binding = 0) uniform View { ViewData view; };
layout(scalar, binding = 1) readonly buffer Cards { Card cards[]; };
layout(scalar, binding = 8) readonly buffer Pool { FragmentPool pool; };
layout(scalar, binding = 9) readonly buffer Heads { uint heads[]; };
layout(binding = 10, rgba16f) writeonly uniform image2D distortion;
layout(binding = 11, rgba16f) writeonly uniform image2D surface;
layout(buffer_reference, scalar, buffer_reference_align = 4) readonly buffer Nodes { FragmentNode nodes[]; };
layout(buffer_reference, scalar, buffer_reference_align = 4) readonly buffer Extras { vec2 extras[]; };
layout(push_constant) uniform Push {
  uint haze_first;   // cards of haze
  uint haze_end;
};

void main() {
  const uvec2 pixel = gl_GlobalInvocationID.xy;
  if (any(greaterThanEqual(pixel, view.size))) return;
  vec4 bent = vec4(0.0), seen = vec4(0.0);
  vec3 through = vec3(1.0);
  uint node = heads[pixel.y * view.size.x + pixel.x];
  while (node != kListEnd) {
    const FragmentNode f = Nodes(pool.address).nodes[node];
    const vec2 extra = Extras(pool.extras).extras[node];
    const float t = dot(through, vec3(1.0 / 3.0));
    if (f.id >= haze_first && f.id < haze_end) {
      bent += t * vec4(extra, length(extra) * vec2(1.0 / f.depth, 1.0));
    } else if (kSurface != 0u) {
      const vec2 motion = screen_motion(view, cards[f.id], vec2(pixel) + 0.5, f.depth);
      seen += surface_sample(extra.x * t, f.depth, motion);
    }
    through *= f.transmittance;
    node = f.next;
  }
  if (kDistortion != 0u) imageStore(distortion, ivec2(pixel), bent);
  if (kSurface != 0u) imageStore(surface, ivec2(pixel), seen);
}
