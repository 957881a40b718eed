// A draw order of cards from one of groups, each card of a group in its turn. Draws go through it backwards, so it is front to back.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "methods/sorted/groups.glsl"

layout(local_size_x = 256) in;
layout(scalar, binding = 2) writeonly buffer Order { uint order[]; };
layout(push_constant) uniform Push {
  uint count;
  uint group_count;
};

void main() {
  const uint i = gl_GlobalInvocationID.x;
  if (i >= count) return;
  const OrderedGroup group = group_of(i, group_count);
  order[count - 1u - (group.place + i - group.first)] = i;
}
