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

/// P(X >= least) of a binomial X of n trials with success probability p, 0 < p < 1.
double at_least(size_t least, size_t n, double p) {
  const auto log_factorial = [](size_t count) { return std::lgamma(double(count) + 1.0); };
  double term = std::exp(log_factorial(n) - log_factorial(least) - log_factorial(n - least) +
                         double(least) * std::log(p) + double(n - least) * std::log1p(-p));
  double sum = 0.0;
  for (size_t k = least; k <= n; ++k) {
    sum += term;
    term *= double(n - k) / double(k + 1) * p / (1.0 - p);
  }
  return sum;
}

/// Position from 0 of the least of n sorted values that the m-th smallest of n draws does not exceed with
/// probability 2.5 %.
size_t low_end(size_t m, size_t n) {
  // Found by bisection: the probability grows with the position.
  size_t first = 1, last = n;  // of how many values are the smallest
  while (first < last) {
    const size_t middle = (first + last) / 2;
    if (at_least(m, n, double(middle) / double(n)) >= 0.025)
      last = middle;
    else
      first = middle + 1;
  }
  return first - 1;
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
  const size_t n = sorted.size(), low = low_end((n + 1) / 2, n);  // the other end mirrors it
  return {.median = quantile(sorted, 0.5),
          .p95 = quantile(sorted, 0.95),
          .min = sorted.front(),
          .low = sorted[low],
          .high = sorted[n - 1 - low],
          .samples = n};
}

bool tells_apart(const Summary& a, const Summary& b) {
  if (std::min(a.samples, b.samples) < kSamplesToTellApart) return false;
  return a.high < b.low || b.high < a.low;
}

}  // namespace plume
