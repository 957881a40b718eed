// The farthest opaque depth of each cell of pixels (reversed depth: the least), against which draws at a lower resolution are tested and
// feathered: a nearer texel would lose smoke that other pixels of the cell see.
#version 460
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 9) uniform sampler2D opaque_depth;
layout(binding = 10, r32f) writeonly uniform image2D farthest;
layout(push_constant) uniform Push {
  uvec2 cells;
  uint divisor;   // pixels a cell, each way
};

void main() {
  const uvec2 cell = gl_GlobalInvocationID.xy;
  if (any(greaterThanEqual(cell, cells))) return;
  const ivec2 last = textureSize(opaque_depth, 0) - 1;
  float depth = 1.0;
  for (uint y = 0u; y < divisor; ++y)
    for (uint x = 0u; x < divisor; ++x) depth = min(depth, texelFetch(opaque_depth, min(ivec2(cell * divisor + uvec2(x, y)), last), 0).r);
  imageStore(farthest, ivec2(cell), vec4(depth));
}
