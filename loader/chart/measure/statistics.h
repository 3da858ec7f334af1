// Medians of noisy times, and how sure they are.
#pragma once

#include <cstddef>
#include <vector>

namespace orris {

/// Value at share `q`, 0..1, of the sorted values, between neighbours in proportion; 0 for none.
double quantile(std::vector<double> values, double q);
double median(std::vector<double> values);

struct Interval {
  double low = 0, high = 0;
  bool operator==(const Interval&) const = default;
};

/// Holds the median of the whole with 95 % probability: percentiles of the medians of samples drawn
/// with replacement. The same values give the same interval. One value, or none: no width.
Interval bootstrapMedian(const std::vector<double>& values);

/// What one setting cost and what the baseline cost beside it, milliseconds a frame.
struct TimePair {
  double own = 0, baseline = 0;
  bool operator==(const TimePair&) const = default;
};

/// Drift and spikes of the machine meet both times of a pair; what is left of them in the ratios goes
/// by the median. 100 pairs of 3 % jitter leave a standard error of 0.6 %.
struct PairedCost {
  double ratio = 1;        ///< median of own / baseline
  Interval ratioInterval;  ///< 95 %
  double median = 0;       ///< of the own times
  std::size_t pairs = 0;
};
PairedCost pairedCost(const std::vector<TimePair>& pairs);

}  // namespace orris
