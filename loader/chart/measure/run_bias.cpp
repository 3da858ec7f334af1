#include <orris/chart/measure/run_bias.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

namespace orris {
namespace {

using Values = std::vector<double>;

/// Red, green, blue or luminance of all pixels.
Values channelOf(const ImageF& image, std::size_t channel) {
  Values values(image.pixels.size() / 3);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const float* rgb = &image.pixels[i * 3];
    values[i] = channel < 3 ? double(rgb[channel]) : luminanceOf(rgb);
  }
  return values;
}

double averageOf(const Values& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}

/// Half of the width of an interval of 95 % in standard errors (Student), by its degrees of freedom.
double studentFactor(double freedom) {
  static constexpr std::array<std::pair<double, double>, 11> kTable = {{{1, 12.706}, {2, 4.303},
      {3, 3.182}, {4, 2.776}, {5, 2.571}, {7, 2.365}, {9, 2.262}, {12, 2.179}, {20, 2.086},
      {60, 2.000}, {1e9, 1.960}}};
  if (!(freedom > 1)) return kTable.front().second;
  for (std::size_t i = 1; i < kTable.size(); ++i) {
    const auto [low, above] = kTable[i - 1];
    const auto [high, below] = kTable[i];
    if (freedom <= high)  // straight over 1 / freedom
      return above + (below - above) * (1 / low - 1 / freedom) / (1 / low - 1 / high);
  }
  return kTable.back().second;
}

/// About a value with two sources of error: `runs` of them, and many pixels of the reference (Welch).
Interval intervalAround(double value, double runVariance, std::size_t runs, double referenceVariance,
                    std::size_t pixels) {
  const double variance = runVariance + referenceVariance;
  const double freedom = variance * variance /
                         (runVariance * runVariance / double(runs - 1) +
                          referenceVariance * referenceVariance / double(pixels) + 1e-300);
  const double half = studentFactor(freedom) * std::sqrt(variance);
  return {value - half, value + half};
}

double varianceOfMean(const Values& values) {
  const double mean = averageOf(values);
  double sum = 0;
  for (const double value : values) sum += (value - mean) * (value - mean);
  return sum / double(values.size() - 1) / double(values.size());
}

/// One channel: errors of all runs against both halves, in relative units.
class Channel {
 public:
  Channel(const std::vector<RunMeans>& runs, const ReferencePicture& reference,
          std::size_t channel)
      : first_(channelOf(reference.first, channel)), second_(channelOf(reference.second, channel)) {
    const Values mean = channelOf(reference.mean, channel);
    const double dark = kDarkShare * averageOf(mean);
    for (std::size_t i = 0; i < mean.size(); ++i) {
      const bool judged = reference.edges.empty() || reference.edges[i] == 0;
      const double scale = mean[i] + dark;
      weight_.push_back(judged && scale > 0 ? 1 / scale : 0);
      judged_ += judged;
    }
    judged_ = std::max(judged_, 1.0);
    for (const RunMeans& run : runs) {
      const Values a = channelOf(run.first, channel), b = channelOf(run.second, channel);
      drift_.push_back(weighted([&](std::size_t i) { return b[i] - a[i]; }));
      Values& both = means_.emplace_back(a.size());
      for (std::size_t i = 0; i < a.size(); ++i) both[i] = (a[i] + b[i]) / 2;
    }
  }

  ChannelBias bias() const {
    ChannelBias result;
    fillSigned(result);
    fillSquare(result);
    result.drift = averageOf(drift_);
    result.driftInterval =
        intervalAround(result.drift, varianceOfMean(drift_), drift_.size(), 0, weight_.size());
    return result;
  }

 private:
  template <class Error>
  double weighted(const Error& error) const {
    double sum = 0;
    for (std::size_t i = 0; i < weight_.size(); ++i) sum += error(i) * weight_[i];
    return sum / judged_;
  }
  double middle(std::size_t i) const { return (first_[i] + second_[i]) / 2; }

  void fillSigned(ChannelBias& result) const {
    Values errors;
    for (const Values& mean : means_)
      errors.push_back(weighted([&](std::size_t i) { return mean[i] - middle(i); }));
    double reference = 0;
    for (std::size_t i = 0; i < weight_.size(); ++i)
      reference += std::pow((first_[i] - second_[i]) / 2 * weight_[i] / judged_, 2);
    result.signedMean = averageOf(errors);
    result.signedInterval = intervalAround(result.signedMean, varianceOfMean(errors), errors.size(),
                                       reference, weight_.size());
  }

  /// Sum over all pairs of different runs, from the sum of all and the sum of products with themselves.
  double pairs(const Values& sum, double count, double own) const {
    double all = 0;
    for (std::size_t i = 0; i < sum.size(); ++i)
      all += (sum[i] - count * first_[i]) * (sum[i] - count * second_[i]) * weight_[i] * weight_[i];
    return (all / judged_ - own) / (count * (count - 1));
  }

  void fillSquare(ChannelBias& result) const {
    const auto count = double(means_.size());
    Values sum(weight_.size()), own;
    for (const Values& mean : means_) {
      double product = 0;
      for (std::size_t i = 0; i < sum.size(); ++i) {
        sum[i] += mean[i];
        product += (mean[i] - first_[i]) * (mean[i] - second_[i]) * weight_[i] * weight_[i];
      }
      own.push_back(product / judged_);
    }
    const double ownSum = std::accumulate(own.begin(), own.end(), 0.0);
    Values without;  // jackknife
    for (std::size_t k = 0; k < means_.size(); ++k) {
      Values rest = sum;
      for (std::size_t i = 0; i < rest.size(); ++i) rest[i] -= means_[k][i];
      without.push_back(pairs(rest, count - 1, ownSum - own[k]));
    }
    double reference = 0;
    for (std::size_t i = 0; i < sum.size(); ++i)
      reference += std::pow((sum[i] / count - middle(i)) * (first_[i] - second_[i]) * weight_[i] *
                                weight_[i] / judged_,
                            2);
    result.square = pairs(sum, count, ownSum);
    result.squareInterval =
        intervalAround(result.square, varianceOfMean(without) * (count - 1) * (count - 1),
                   means_.size(), reference, weight_.size());
  }

  Values first_, second_, weight_;
  double judged_ = 0;
  std::vector<Values> means_;
  Values drift_;
};

}  // namespace

RunBias biasOfRuns(const std::vector<RunMeans>& runs, const ReferencePicture& reference) {
  assert(runs.size() >= 3);
  RunBias result;
  for (std::size_t channel = 0; channel < result.size(); ++channel)
    result[channel] = Channel(runs, reference, channel).bias();
  return result;
}

double signedRoot(double square) { return std::copysign(std::sqrt(std::abs(square)), square); }

}  // namespace orris
