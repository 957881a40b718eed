#include "sandbox/measure/statistics.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace plume {
namespace {

double quantile(std::span<const double> sorted, double q) {
  const double position = q * static_cast<double>(sorted.size() - 1);
  const size_t below = static_cast<size_t>(position);
  const size_t above = std::min(below + 1, sorted.size() - 1);
  return std::lerp(sorted[below], sorted[above], position - static_cast<double>(below));
}

}  // namespace

Summary summarise(std::span<const double> values) {
  if (values.empty()) throw std::invalid_argument("nothing to summarise: no values");
  std::vector<double> sorted(values.begin(), values.end());
  // A NaN has no place in an order, and nothing lies between two infinities.
  for (const double value : sorted)
    if (!std::isfinite(value))
      throw std::invalid_argument("cannot summarise " + std::to_string(value) + ": values must be finite");
  std::sort(sorted.begin(), sorted.end());
  return {.median = quantile(sorted, 0.5),
          .p95 = quantile(sorted, 0.95),
          .min = sorted.front(),
          .samples = sorted.size()};
}

}  // namespace plume
