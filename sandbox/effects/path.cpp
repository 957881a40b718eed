#include "sandbox/effects/path.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace plume {

Path::Path(std::vector<Key> keys) : keys_(std::move(keys)) {
  if (keys_.size() < 2) throw std::invalid_argument("a path needs at least 2 keys");
  before_.reserve(keys_.size());
  for (size_t i = 0; i < keys_.size(); ++i) {
    if (i == 0) {
      before_.push_back(0);
      continue;
    }
    if (keys_[i].tick <= keys_[i - 1].tick) throw std::invalid_argument("path keys do not ascend");
    const double length = glm::distance(glm::dvec3(keys_[i - 1].position), glm::dvec3(keys_[i].position));
    if (!(length_m() + length <= kLongest_m)) throw std::invalid_argument("a path is too long");
    before_.push_back(before_.back() + static_cast<uint64_t>(std::llround(length * (1 << kFractionBits))));
  }
}

glm::vec3 Path::at(uint32_t tick) const {
  const auto next = std::ranges::upper_bound(keys_, tick, {}, &Key::tick);
  if (next == keys_.begin()) return keys_.front().position;
  if (next == keys_.end()) return keys_.back().position;
  const Key& key = *std::prev(next);
  return glm::mix(key.position, next->position,
                  static_cast<float>(tick - key.tick) / static_cast<float>(next->tick - key.tick));
}

Path::Way Path::way(uint32_t tick) const {
  const auto next = std::ranges::upper_bound(keys_, tick, {}, &Key::tick) - keys_.begin();
  if (next == 0) return {0, 1};
  const size_t i = static_cast<size_t>(next);
  if (i == keys_.size()) return {before_.back(), 1};
  const uint32_t width = keys_[i].tick - keys_[i - 1].tick, x = tick - keys_[i - 1].tick;
  decltype(Way::numerator) numerator = before_[i - 1];
  numerator = numerator * width + (before_[i] - before_[i - 1]) * decltype(numerator){x};
  return {numerator, width};
}

double Path::length_m() const {
  return static_cast<double>(before_.back()) / (1 << kFractionBits);
}

}  // namespace plume
