// Random numbers that are the same on every machine: the distributions of the standard library are each
// vendor's own, and so are the last bits of exp() and its like. These take the bits of an engine that the
// standard does fix, and round nothing.
#ifndef PLUME_TESTS_DICE_H
#define PLUME_TESTS_DICE_H

#include <cmath>
#include <cstdint>
#include <random>

namespace plume {

class Dice {
 public:
  explicit Dice(uint64_t seed) : engine_(seed) {}

  /// 0 .. count - 1. The lower ones come up more often, by one in 2^64 / count.
  uint64_t below(uint64_t count) { return engine_() % count; }
  bool chance(uint32_t percent) { return below(100) < percent; }
  /// 2^least to 2^(most + 1), each octave as often, in steps of a 64th.
  double octaves(int least, int most) {
    const int octave = least + int(below(uint64_t(most - least) + 1));
    return std::ldexp(64.0 + double(below(64)), octave - 6);
  }
  template <class Items>
  const auto& one_of(const Items& items) {
    return items[below(items.size())];
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace plume
#endif
