// Fragments of one pixel take turns: while one is at work, no other of the same pixel is. The method says in take_turn() what the work
// is; methods/parts/pixel_nodes/spinlock.glsl or interlock.glsl sees to the turns.
#ifndef PLUME_PIXEL_NODES_TURN_GLSL
#define PLUME_PIXEL_NODES_TURN_GLSL
#include "methods/parts/pixel_nodes/pixel_nodes.h"
#include "methods/parts/pixel_nodes/seen.glsl"

layout(scalar, binding = 8) coherent buffer Turns { uint turns[]; };

// `before`: how many fragments of the pixel had their turn.
void take_turn(uint pixel, uint before, Fragment f);

#endif
