// Sums the optical depth of a light grid's cells along the light: texel (s, t, l) is of the face in front of cell l, and holds
// (optical depth between the light and the face, extinction around the face in 1/m).
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_shader_image_load_formatted : require
#include "effects/light_body.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(scalar, binding = 3) readonly buffer Grids { LightGrid grids[]; };
layout(scalar, binding = 4) readonly buffer Cells { uint cells[]; };
layout(binding = 5) writeonly uniform image3D volume;
layout(push_constant) uniform Push { uint which; };

void main() {
  const uint n = grids[which].cells;
  const float inv_length = 1.0 / grids[which].cell.z;
  const uvec2 ray = gl_GlobalInvocationID.xy;
  if (any(greaterThanEqual(ray, uvec2(n)))) return;
  float depth = 0.0, before = 0.0;
  for (uint l = 0u; l < n; ++l) {
    const float here = float(cells[(l * n + ray.y) * n + ray.x]) / kDepthUnit;
    imageStore(volume, ivec3(ray, l), vec4(depth, 0.5 * (before + here) * inv_length, 0.0, 0.0));
    depth += here;
    before = here;
  }
}
