#include "sandbox/effects/spawn_schedule.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace plume {
namespace {

constexpr int kFractionBits = 20;

/// Births a second or a metre to 2^-20 births a tick or a metre. The product is exact, so only the division
/// and the rounding round.
uint64_t fixed_point(double births, double most, int divisor, const char* what) {
  if (!(births >= 0 && births <= most)) throw std::invalid_argument(std::string(what) + " out of range");
  return static_cast<uint64_t>(std::llround(births * (1 << kFractionBits) / divisor));
}

}  // namespace

SpawnSchedule::SpawnSchedule(const Spawn& spawn, const SpawnContext& context)
    : per_metre_(fixed_point(spawn.per_metre, 1e6, 1, "births a metre")),
      last_spawning_tick_(int64_t{context.stop_tick} - 1),
      per_root_(context.per_root),
      max_life_(std::max(1u, context.life.value_or(spawn.life_ticks.max))) {
  for (const Spawn::RateKey& key : spawn.rate) {
    RateKey next{key.tick, fixed_point(key.per_second, 1e9, kTicksPerSecond, "spawn rate"), 0};
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
  if (context.path && per_metre_ > 0) path_ = *context.path;

  const uint32_t end =
      std::max({rate_.empty() ? 0 : rate_.back().tick, bursts_.empty() ? 0 : bursts_.back().tick,
                path_ ? path_->keys().back().tick : 0});
  const Wide total = static_cast<Wide>(roots(end)) * per_root_;
  if (total > kMaxBirths)
    throw std::overflow_error(
        fmt::format("{} particles are born in all, expected at most {}", total, kMaxBirths));
  births_total_ = static_cast<uint64_t>(total);
  if (births_total_ == 0) return;
  last_birth_tick_ = end;  // birth_tick() searches up to here
  last_birth_tick_ = birth_tick(births_total_ - 1);
  capacity_ = std::min(largest_window() * per_root_, births_total_);
}

uint64_t SpawnSchedule::by_bursts(int64_t tick) const {
  tick = std::min(tick, last_spawning_tick_);
  const auto next = std::ranges::upper_bound(bursts_, tick, {}, &BurstKey::tick);
  return next == bursts_.begin() ? 0 : std::prev(next)->count_until;
}

SpawnSchedule::Count SpawnSchedule::by_rate(int64_t tick) const {
  tick = std::min(tick, last_spawning_tick_);
  const auto next = std::ranges::upper_bound(rate_, tick, {}, &RateKey::tick);
  if (next == rate_.begin()) return {};
  const RateKey& key = *std::prev(next);
  Wide area = key.area_before, width = 1;
  // Bounds: ticks below 2^32 and rates below 2^45 keep every term below 2^112.
  if (next != rate_.end()) {
    width = next->tick - key.tick;
    const Wide x = static_cast<Wide>(tick + 1 - key.tick);
    area = area * width + key.rate * x * (2 * width - x) + next->rate * x * x;
  }
  const Wide unit = width << (kFractionBits + 1);
  return {static_cast<uint64_t>(area / unit), area % unit, static_cast<uint32_t>(width)};
}

SpawnSchedule::Count SpawnSchedule::by_distance(int64_t tick) const {
  tick = std::min(tick, last_spawning_tick_);
  if (!path_ || tick < 0) return {};
  const auto [way, width] = path_->way(static_cast<uint32_t>(tick));
  const Wide births = way * per_metre_;  // below 2^82 * 2^40
  const Wide unit = static_cast<Wide>(width) << (kFractionBits + Path::kFractionBits);
  return {static_cast<uint64_t>(births / unit), births % unit, width};
}

uint64_t SpawnSchedule::roots(int64_t tick) const {
  return by_bursts(tick) + by_rate(tick).whole + by_distance(tick).whole;
}

uint64_t SpawnSchedule::births(uint32_t tick) const {
  return roots(tick) * per_root_;
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

uint64_t SpawnSchedule::rounded_up(const Count& a, const Count& b) {
  return a.whole - b.whole + (a.part * b.of > b.part * a.of ? 1 : 0);
}

/// What the rate and the way give in one tick, in 2^-40 births, less than 2 of these short.
SpawnSchedule::Wide SpawnSchedule::gain(int64_t tick) const {
  if (tick < 0 || tick > last_spawning_tick_) return 0;
  Wide births = 0;
  const auto next = std::ranges::upper_bound(rate_, tick, {}, &RateKey::tick);
  if (next != rate_.begin() && next != rate_.end()) {
    const RateKey& key = *std::prev(next);
    const uint32_t width = next->tick - key.tick;
    const Wide x = static_cast<Wide>(tick - key.tick);  // twice the trapezium over [x, x + 1)
    const Wide area = key.rate * (2 * width - 2 * x - 1) + next->rate * (2 * x + 1);
    births += (area << (kFractionBits - 1)) / width;
  }
  const auto by_way = [&](uint32_t t) -> Wide {
    const auto [way, width] = path_->way(t);
    return way * per_metre_ / width;
  };
  if (path_ && tick > 0) births += by_way(uint32_t(tick)) - by_way(uint32_t(tick) - 1);
  return births;
}

/// An upper bound of roots(t) - roots(t - life) over all ticks, from a few ticks only: between two ticks at
/// which a key or a burst enters or leaves the window, bursts in it stay the same, and what rate and way give
/// in it is a quadratic function of t, so the largest is at an end or where the window stops growing.
/// Dropping fractions makes at most 1 of a difference for each kind; finding that place by rounded gains
/// makes less than 2^-6 over 2^32 ticks.
uint64_t SpawnSchedule::largest_window() const {
  std::vector<int64_t> changes{0};
  const auto add = [&](int64_t tick) {
    for (const int64_t change : {tick, tick + max_life_})
      if (change <= last_birth_tick_) changes.push_back(change);
  };
  for (const RateKey& key : rate_) add(key.tick);
  for (const BurstKey& burst : bursts_) add(burst.tick);
  if (path_)
    for (const Path::Key& key : path_->keys()) add(key.tick);
  std::ranges::sort(changes);
  changes.erase(std::unique(changes.begin(), changes.end()), changes.end());
  changes.push_back(int64_t{last_birth_tick_} + 1);

  const uint64_t both = path_ && !rate_.empty() ? 1 : 0;
  const auto window = [&](int64_t tick) {
    const int64_t dead = tick - max_life_;
    return by_bursts(tick) - by_bursts(dead) + rounded_up(by_rate(tick), by_rate(dead)) +
           rounded_up(by_distance(tick), by_distance(dead)) + both;
  };
  const auto grows_after = [&](int64_t tick) { return gain(tick + 1) > gain(tick + 1 - max_life_); };
  uint64_t largest = 0;
  for (size_t i = 0; i + 1 < changes.size(); ++i) {
    const int64_t first = changes[i], last = changes[i + 1] - 1;
    int64_t low = first, high = last;
    while (low < high) {
      const int64_t middle = low + (high - low) / 2;
      if (grows_after(middle))
        low = middle + 1;
      else
        high = middle;
    }
    largest = std::max({largest, window(first), window(last), window(low) + (low > first && low < last)});
  }
  return largest;
}

}  // namespace plume
