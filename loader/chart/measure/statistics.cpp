#include <orris/chart/measure/statistics.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace orris {
namespace {

constexpr int kResamples = 2000;
constexpr double kTail = 0.025;

}  // namespace

double quantile(std::vector<double> values, double q) {
  if (values.empty()) return 0;
  const double at = std::clamp(q, 0.0, 1.0) * double(values.size() - 1);
  const auto below = std::size_t(at);
  const auto middle = values.begin() + std::ptrdiff_t(below);
  std::nth_element(values.begin(), middle, values.end());
  if (below + 1 == values.size()) return *middle;
  const double next = *std::min_element(middle + 1, values.end());
  return *middle + (at - double(below)) * (next - *middle);
}

double median(std::vector<double> values) { return quantile(std::move(values), 0.5); }

Interval bootstrapMedian(const std::vector<double>& values) {
  if (values.size() < 2) return {median(values), median(values)};
  std::mt19937_64 random(1);
  std::vector<double> medians(kResamples), sample(values.size());
  for (double& result : medians) {
    for (double& value : sample) value = values[random() % values.size()];
    result = median(sample);
  }
  return {quantile(medians, kTail), quantile(medians, 1 - kTail)};
}

PairedCost pairedCost(const std::vector<TimePair>& pairs) {
  std::vector<double> ratios, own;
  for (const TimePair& pair : pairs) {
    own.push_back(pair.own);
    if (pair.baseline > 0) ratios.push_back(pair.own / pair.baseline);
  }
  PairedCost cost;
  cost.pairs = pairs.size();
  cost.median = median(own);
  if (ratios.empty()) return cost;
  cost.ratio = median(ratios);
  cost.ratioInterval = bootstrapMedian(ratios);
  return cost;
}

}  // namespace orris
