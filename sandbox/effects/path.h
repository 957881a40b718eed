// The way an instance travels: positions at ticks since the call, relative to where it was called, world
// axes. Linear between keys, constant outside them.
//
// The length of each segment is rounded to 2^-20 m once; what is travelled of it by a tick is the exact share
//     (L_before W + L x) / W,   x = tick - key's tick, W = ticks of the segment, L = its length,
// so the way up to any tick is known without the ticks before it, never decreases, and no rounding adds up.
#ifndef PLUME_EFFECTS_PATH_H
#define PLUME_EFFECTS_PATH_H

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace plume {

class Path {
 public:
  struct Key {
    uint32_t tick;       // since the call
    glm::vec3 position;  // m
    bool operator==(const Key&) const = default;
  };
  static constexpr int kFractionBits = 20;
  static constexpr double kLongest_m = 1e9;

  /// Throws std::invalid_argument for fewer than 2 keys, ticks that do not ascend, and a way that is longer
  /// than kLongest_m or not finite.
  explicit Path(std::vector<Key> keys);

  const std::vector<Key>& keys() const { return keys_; }
  glm::vec3 at(uint32_t tick) const;
  /// What is travelled from the first key up to `tick`, in 2^-20 m: numerator / denominator.
  struct Way {
    __extension__ unsigned __int128 numerator;  // below 2^82
    uint32_t denominator;
  };
  Way way(uint32_t tick) const;
  double length_m() const;
  bool operator==(const Path&) const = default;

 private:
  std::vector<Key> keys_;
  std::vector<uint64_t> before_;  // a key: the way up to it, in 2^-20 m
};

}  // namespace plume
#endif
