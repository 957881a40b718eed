// Depth peeling: the indirect draws of each peel, an advance and the cards. Those beyond the depth complexity draw nothing, and none
// draws when fewer peels were recorded than it takes: then the frame is drawn again.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "methods/peel/peel.h"
#include "shared/draw_command.h"
#include "shared/workload.h"

layout(local_size_x = 64) in;
layout(scalar, binding = 7) readonly buffer Work { Workload work; };
layout(scalar, binding = 8) readonly buffer Counts { PeelCounts counts; };
layout(scalar, binding = 9) writeonly buffer Draws { DrawCommand draws[]; };
layout(push_constant) uniform Push {
  uint most;       // layers that may be peeled
  uint ends;       // layers of a pixel that a peel takes
  uint recorded;   // peels
};

void main() {
  const uint i = gl_GlobalInvocationID.x;
  if (i >= recorded) return;
  const uint needed = (min(counts.deepest, most) + ends - 1u) / ends;
  const bool drawn = i < needed && needed <= recorded;
  draws[2u * i] = DrawCommand(3u, drawn ? 1u : 0u, 0u, 0u);
  draws[2u * i + 1u] = DrawCommand(4u, drawn ? work.count : 0u, 0u, 0u);
}
