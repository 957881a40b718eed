// Turns by fragment shader interlock: the device keeps fragments of one pixel apart. The shader names the mode, ordered or not, and
// calls interlocked_turn() between beginInvocationInterlockARB() and endInvocationInterlockARB(), which only main() may call.
#ifndef PLUME_PIXEL_NODES_INTERLOCK_GLSL
#define PLUME_PIXEL_NODES_INTERLOCK_GLSL
#include "methods/parts/pixel_nodes/turn.glsl"

void interlocked_turn(bool wanted, Fragment f) {
  if (!wanted) return;
  const uint pixel = pixel_index(view.size), before = turns[pixel];
  take_turn(pixel, before, f);
  turns[pixel] = before + 1u;
}

#endif
