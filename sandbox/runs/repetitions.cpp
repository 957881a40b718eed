#include "sandbox/runs/repetitions.h"

#include <cmath>

#include "sandbox/measure/statistics.h"

namespace plume {

std::optional<double> drift(std::span<const double> repetitions_ms) {
  const size_t half = repetitions_ms.size() / 2;
  if (half == 0) return std::nullopt;
  const Summary early = summarise(repetitions_ms.first(half)), late = summarise(repetitions_ms.last(half));
  if (!tells_apart(early, late) || early.median <= 0.0) return std::nullopt;
  const double ratio = late.median / early.median;
  return std::abs(ratio - 1.0) > 0.05 ? std::optional(ratio) : std::nullopt;
}

}  // namespace plume
