// How many ticks one dispatch of the catch-up kernel may integrate.
//
// Mesa's llvmpipe ends every loop of an invocation, without a word, once all its loops together have turned
// 65535 times (LP_MAX_TGSI_LOOP_ITERATIONS, Mesa 22.3), and on GPUs a dispatch of seconds is taken for a
// hang. So a long way is cut into dispatches whose loops turn fewer times than that, whatever the particles
// meet.
#ifndef PLUME_EFFECTS_DISPATCH_LENGTH_H
#define PLUME_EFFECTS_DISPATCH_LENGTH_H

#include <array>

#include "shaders/shared/particle.h"

namespace plume {

/// How often each kind of loop in shaders/effects/ turns at most, a tick, for an emitter. A loop's last,
/// failed test counts too.
class LoopsPerTick {
 public:
  LoopsPerTick() = default;
  LoopsPerTick(const shared::EmitterData& emitter, uint32_t path_keys);

  /// Of several emitters in one kernel: their particles share invocations' loops.
  LoopsPerTick& widen(const LoopsPerTick& other);
  uint32_t ticks_per_dispatch() const;

 private:
  std::array<uint32_t, 6> turns_{};
};

}  // namespace plume
#endif
