#include "sandbox/effects/clock.h"

#include <algorithm>

namespace plume {

std::optional<uint32_t> Clock::local(uint32_t tick) const {
  if (tick < call_tick_) return {};
  uint32_t passed = tick - call_tick_;
  // The call itself is tick 0 whatever happens then; a tick stands still or leads from the one before it.
  for (const auto& [first, end] : standing_) {
    const uint32_t from = std::max(first, call_tick_ + 1), until = std::min(end, tick + 1);
    if (until > from) passed -= until - from;
  }
  return passed;
}

bool Clock::stood_still(uint32_t tick) const {
  const auto after = standing_.upper_bound(tick);
  return after != standing_.begin() && std::prev(after)->second > tick;
}

void Clock::stand_still(uint32_t first, uint32_t end) {
  if (first >= end) return;
  auto next = standing_.lower_bound(first);
  if (next != standing_.begin() && std::prev(next)->second >= first) --next;
  while (next != standing_.end() && next->first <= end) {
    first = std::min(first, next->first);
    end = std::max(end, next->second);
    next = standing_.erase(next);
  }
  standing_.emplace(first, end);
}

void Clock::forget_from(uint32_t tick) {
  standing_.erase(standing_.lower_bound(tick), standing_.end());
  if (!standing_.empty()) {
    auto& end = standing_.rbegin()->second;
    end = std::min(end, tick);
  }
}

}  // namespace plume
