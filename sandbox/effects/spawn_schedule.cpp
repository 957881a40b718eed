#include "sandbox/effects/spawn_schedule.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace plume {
namespace {

constexpr int kFractionBits = 20;

/// Particles a second to 2^-20 particles a tick. The product is exact, so only the division and the rounding
/// round.
uint64_t fixed_point(double per_second) {
  if (!(per_second >= 0 && per_second <= 1e9)) throw std::invalid_argument("spawn rate out of range");
  return static_cast<uint64_t>(std::llround(per_second * (1 << kFractionBits) / kTicksPerSecond));
}

}  // namespace

SpawnSchedule::SpawnSchedule(const Spawn& spawn) : max_life_(std::max(1u, spawn.life_ticks.max)) {
  for (const Spawn::RateKey& key : spawn.rate) {
    RateKey next{key.tick, fixed_point(key.per_second), 0};
    if (!rate_.empty()) {
      const RateKey& last = rate_.back();
      if (next.tick <= last.tick) throw std::invalid_argument("spawn rate keys do not ascend");
      next.area_before =
          last.area_before + static_cast<Wide>(last.rate + next.rate) * (next.tick - last.tick);
    }
    rate_.push_back(next);
  }
  uint64_t count = 0;
  for (const Spawn::Burst& burst : spawn.bursts) {
    if (!bursts_.empty() && burst.tick <= bursts_.back().tick)
      throw std::invalid_argument("spawn bursts do not ascend");
    bursts_.push_back({burst.tick, count += burst.count});
  }

  const uint32_t end =
      std::max(rate_.empty() ? 0 : rate_.back().tick, bursts_.empty() ? 0 : bursts_.back().tick);
  births_total_ = births(end);
  if (births_total_ == 0) return;
  last_birth_tick_ = end;  // birth_tick() searches up to here
  last_birth_tick_ = birth_tick(births_total_ - 1);
  // Before max_life_ - 1 nothing has left the window, and after the last birth nothing enters it.
  for (uint64_t tick = std::min(max_life_ - 1, last_birth_tick_); tick <= last_birth_tick_; ++tick) {
    const auto t = static_cast<uint32_t>(tick);
    capacity_ = std::max(capacity_, births(t) - first_alive(t));
  }
}

uint64_t SpawnSchedule::births(uint32_t tick) const {
  uint64_t count = 0;
  const auto burst = std::ranges::upper_bound(bursts_, tick, {}, &BurstKey::tick);
  if (burst != bursts_.begin()) count = std::prev(burst)->count_until;

  const auto next = std::ranges::upper_bound(rate_, tick, {}, &RateKey::tick);
  if (next == rate_.begin()) return count;
  const RateKey& key = *std::prev(next);
  if (next == rate_.end()) return count + static_cast<uint64_t>(key.area_before >> (kFractionBits + 1));
  // Bounds: ticks below 2^32 and rates below 2^45 keep every term below 2^112.
  const Wide width = next->tick - key.tick;
  const Wide x = static_cast<Wide>(tick) + 1 - key.tick;
  const Wide area = key.area_before * width + key.rate * x * (2 * width - x) + next->rate * x * x;
  return count + static_cast<uint64_t>(area / (width << (kFractionBits + 1)));
}

uint32_t SpawnSchedule::birth_tick(uint64_t k) const {
  if (k >= births_total_) throw std::out_of_range("no particle of that number is ever born");
  uint32_t low = 0, high = last_birth_tick_;
  while (low < high) {
    const uint32_t middle = low + (high - low) / 2;
    if (births(middle) > k)
      high = middle;
    else
      low = middle + 1;
  }
  return low;
}

}  // namespace plume
