// A view's shader defines inspect() with the functions that the frame was drawn with, and includes this.
#ifndef PLUME_INSPECT_GLSL
#define PLUME_INSPECT_GLSL
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 8, local_size_y = 8) in;
layout(scalar, binding = 31) buffer Values { uint values[]; };   // bits of floats, row by row
layout(push_constant, scalar) uniform Look {
  uvec2 size;   // of the picture
  uint slice;   // that is asked for
} look;

// The number of a pixel; false where there is none.
bool inspect(uvec2 pixel, out float value);

void main() {
  const uvec2 pixel = gl_GlobalInvocationID.xy;
  if (any(greaterThanEqual(pixel, look.size))) return;
  float value = 0.0;
  values[pixel.y * look.size.x + pixel.x] = inspect(pixel, value) ? floatBitsToUint(value) : 0x7fc00000u;
}

#endif
