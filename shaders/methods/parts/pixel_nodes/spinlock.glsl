// Turns by a spin lock: a bit of the pixel's word is taken, the work is done, and the bit is given back with the count raised.
// Lanes that run in lockstep may want the same pixel, and one that waits for another of its own group would wait forever: so the
// lock is taken, used and given back within one round of the loop, and only then do those go round again that did not get it. Helper
// invocations, which cover no sample, would never get it. The test stands at the loop's end: where lanes are masked, no idle round
// follows the last.
// Limit: who comes first is the device's choice. What depends on the order of turns differs from run to run.
#ifndef PLUME_PIXEL_NODES_SPINLOCK_GLSL
#define PLUME_PIXEL_NODES_SPINLOCK_GLSL
#include "methods/parts/pixel_nodes/turn.glsl"

void wait_for_turn(bool wanted, Fragment f) {
  const uint pixel = pixel_index(view.size);
  bool waiting = wanted && gl_SampleMaskIn[0] != 0;
  do {
    if (waiting) {
      const uint word = atomicOr(turns[pixel], kTurnTaken);
      if ((word & kTurnTaken) == 0u) {
        memoryBarrierBuffer();   // sees what the last one wrote
        take_turn(pixel, word, f);
        memoryBarrierBuffer();   // before the next one may
        atomicExchange(turns[pixel], word + 1u);
        waiting = false;
      }
    }
  } while (waiting);
}

#endif
