// What a list of timings is reduced to in a report, and when two of them are called different.
//
// The interval of the median is the percentile bootstrap (Efron, "Bootstrap Methods: Another Look at the
// Jackknife", The Annals of Statistics 7(1), 1979): what 95 % of the medians of n draws with replacement lie
// in. Its section 3 gives their distribution in closed form: the median of n = 2m - 1 draws is at most the
// k-th smallest value when at least m of them are, which is a binomial sum of n and k / n. So nothing is
// drawn at random here, and the same values give the same interval in any order. For an even count the
// interval spans those of both middle draws, and so holds that of their mean. Its ends are always measured
// values.
//
// Limits: of values that are independent of each other it holds the true median in 95 % of cases for many
// values, 96 % for n = 25, 94 % for n = 5, at worst 88 % for n = 7, whatever their distribution (which must
// be continuous). Up to 6 values it is their smallest to their largest and cannot hold more: 88 % for 4, 75 %
// for 3, 50 % for 2. It knows of this run only: what was slow or fast throughout does not show.
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
  double low = 0.0, high = 0.0;  ///< interval of the median, 95 %
  size_t samples = 0;
};

/// Quantile q of n sorted values is interpolated linearly at position q * (n - 1), counted from 0 (definition
/// 7 of Hyndman and Fan, "Sample Quantiles in Statistical Packages", The American Statistician 50(4), 1996).
/// The median of an even count is so the mean of the middle two. Throws std::invalid_argument when `values`
/// is empty or has a NaN or an infinity.
Summary summarise(std::span<const double> values);

/// With fewer, values of two equal distributions lie wholly apart in more than 5 % of cases: 2 of the
/// C(2n, n) orders in which they can stand.
constexpr size_t kSamplesToTellApart = 4;

/// Two are called different only when their intervals do not meet, and when both have values enough.
bool tells_apart(const Summary& a, const Summary& b);

}  // namespace plume
#endif
