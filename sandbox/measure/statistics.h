// What a list of timings is reduced to in a report.
#ifndef PLUME_MEASURE_STATISTICS_H
#define PLUME_MEASURE_STATISTICS_H

#include <cstddef>
#include <span>

namespace plume {

/// In the unit of the values that were summarised.
struct Summary {
  double median = 0.0;
  double p95 = 0.0;  ///< 95% of the values are at or below it
  double min = 0.0;
  size_t samples = 0;
};

/// Quantile q of n sorted values is interpolated linearly at position q * (n - 1), counted from 0 (definition
/// 7 of Hyndman and Fan, "Sample Quantiles in Statistical Packages", The American Statistician 50(4), 1996).
/// The median of an even count is so the mean of the middle two. Throws std::invalid_argument when `values`
/// is empty or has a NaN or an infinity.
Summary summarise(std::span<const double> values);

}  // namespace plume
#endif
