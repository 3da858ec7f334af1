#include <orris/chart/measure/error_meter.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

namespace orris {
namespace {

// Frames in a row are not independent where a pack reuses earlier ones. The means of long runs nearly
// are, so the noise of the mean is judged by these.
constexpr int kBatches = 8;
constexpr double kRelMseFloor = 0.01;
constexpr double kTrimmed = 0.001;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::vector<double> luminances(const ImageF& image) {
  std::vector<double> result(image.pixels.size() / 3);
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = luminanceOf(&image.pixels[i * 3]);
  return result;
}

double meanOf(const std::vector<double>& values) {
  return values.empty() ? 0
                        : std::accumulate(values.begin(), values.end(), 0.0) /
                              static_cast<double>(values.size());
}

/// Of the mean of the values; they count as independent.
double standardError(const std::vector<double>& values) {
  if (values.size() < 2) return 0;
  const double mean = meanOf(values);
  double sum = 0;
  for (const double value : values) sum += (value - mean) * (value - mean);
  const auto count = static_cast<double>(values.size());
  return std::sqrt(sum / (count - 1) / count);
}

double rootOf(double square) { return std::sqrt(std::max(0.0, square)); }

Interval rootInterval(double square, double error) {
  return {rootOf(square - 2 * error), rootOf(square + 2 * error)};
}

/// Means of kBatches parts, whose order is kept.
std::vector<double> partMeans(const std::vector<double>& values) {
  const std::size_t parts = std::min<std::size_t>(kBatches, values.size());
  std::vector<double> sums(parts), counts(parts);
  for (std::size_t i = 0; i < values.size(); ++i) {
    sums[i * parts / values.size()] += values[i];
    counts[i * parts / values.size()] += 1;
  }
  for (std::size_t i = 0; i < parts; ++i) sums[i] /= counts[i];
  return sums;
}

}  // namespace

const AccumulatedError& ErrorSummary::after(int count) const {
  assert(!accumulated.empty());
  std::size_t best = 0;
  for (std::size_t i = 0; i < accumulated.size(); ++i)
    if (accumulated[i].frames <= count) best = i;
  return accumulated[best];
}

ErrorMeter::ErrorMeter(const ReferencePicture& reference, int frames)
    : reference_(reference),
      frames_(std::max(frames, 1)),
      pixels_(reference.mean.pixels.size() / 3),
      first_(luminances(reference.first)),
      second_(luminances(reference.second)),
      sum_(pixels_ * 3),
      squares_(pixels_ * 3),
      luminanceSum_(pixels_),
      luminanceSquares_(pixels_) {
  const double dark = kDarkShare * meanLuminance(reference.mean);
  for (const double luminance : luminances(reference.mean)) {
    const double scale = luminance + dark;
    weight_.push_back(scale > 0 ? 1 / (scale * scale) : 0);
  }
  for (std::size_t i = 0; i < reference.edges.size(); ++i)
    if (reference.edges[i] != 0) weight_[i] = 0;
  const auto edges = std::count_if(reference.edges.begin(), reference.edges.end(),
                                   [](std::uint8_t edge) { return edge != 0; });
  judged_ = std::max(1.0, double(pixels_) - double(edges));
  const int batches = std::min(kBatches, frames_);
  batches_.assign(std::size_t(batches), std::vector<double>(pixels_));
  batchFrames_.assign(std::size_t(batches), 0);
  for (int length = 1; length <= frames_; length *= 2)
    runs_.push_back({length, 0, std::vector<double>(pixels_), {}});
}

void ErrorMeter::add(const ImageF& picture) {
  assert(picture.pixels.size() == pixels_ * 3 && added_ < frames_);
  ImageF finite = picture;
  for (std::size_t i = 0; i < pixels_; ++i) {
    float* pixel = &finite.pixels[i * 3];
    if (std::isfinite(pixel[0]) && std::isfinite(pixel[1]) && std::isfinite(pixel[2])) continue;
    std::fill_n(pixel, 3, 0.0f);
    ++notFinite_;
  }
  for (std::size_t i = 0; i < finite.pixels.size(); ++i) {
    const double value = finite.pixels[i];
    sum_[i] += value;
    squares_[i] += value * value;
  }
  const std::vector<double> luminance = luminances(finite);
  const auto batch = std::size_t(added_) * batches_.size() / std::size_t(frames_);
  for (std::size_t i = 0; i < pixels_; ++i) {
    luminanceSum_[i] += luminance[i];
    luminanceSquares_[i] += luminance[i] * luminance[i];
    batches_[batch][i] += luminance[i];
  }
  ++batchFrames_[batch];
  addToRuns(luminance);
  ++added_;
}

void ErrorMeter::addToRuns(const std::vector<double>& luminance) {
  for (Run& run : runs_) {
    for (std::size_t i = 0; i < pixels_; ++i) run.sum[i] += luminance[i];
    if (++run.filled < run.length) continue;
    run.squares.push_back(squaredError(run.sum, run.length));
    run.filled = 0;
    std::fill(run.sum.begin(), run.sum.end(), 0.0);
  }
}

double ErrorMeter::squaredError(const std::vector<double>& sum, double count) const {
  double result = 0;
  for (std::size_t i = 0; i < pixels_; ++i) {
    const double mean = sum[i] / count;
    result += (mean - first_[i]) * (mean - second_[i]) * weight_[i];
  }
  return result / judged_;
}

/// The squared error of the mean of the batches, less the noise that is left in that mean.
double ErrorMeter::squaredBias(const std::vector<const std::vector<double>*>& batches) const {
  const auto count = static_cast<double>(batches.size());
  double result = 0;
  for (std::size_t i = 0; i < pixels_; ++i) {
    double sum = 0, squares = 0;
    for (const std::vector<double>* batch : batches) {
      sum += (*batch)[i];
      squares += (*batch)[i] * (*batch)[i];
    }
    const double mean = sum / count;
    const double variance = count > 1 ? (squares - sum * mean) / (count - 1) : 0;
    const double product = (mean - first_[i]) * (mean - second_[i]);
    result += (product - variance / count) * weight_[i];
  }
  return result / judged_;
}

void ErrorMeter::fillBias(ErrorSummary& summary) const {
  std::vector<std::vector<double>> means;
  for (std::size_t b = 0; b < batches_.size(); ++b) {
    if (batchFrames_[b] == 0) continue;
    means.push_back(batches_[b]);
    for (double& value : means.back()) value /= batchFrames_[b];
  }
  std::vector<const std::vector<double>*> all;
  for (const auto& mean : means) all.push_back(&mean);
  const double square = squaredBias(all);
  // Jackknife: the spread of the results without each batch in turn.
  std::vector<double> without;
  for (std::size_t b = 0; all.size() > 1 && b < all.size(); ++b) {
    std::vector<const std::vector<double>*> rest = all;
    rest.erase(rest.begin() + std::ptrdiff_t(b));
    without.push_back(squaredBias(rest));
  }
  const double error =
      without.empty() ? 0 : standardError(without) * static_cast<double>(without.size() - 1);
  summary.bias = rootOf(square);
  summary.biasInterval = rootInterval(square, error);
  double sum = 0;
  for (std::size_t i = 0; i < pixels_; ++i)
    sum += (luminanceSum_[i] / added_ - (first_[i] + second_[i]) / 2) * std::sqrt(weight_[i]);
  summary.signedBias = sum / judged_;
}

double ErrorMeter::noise() const {
  if (added_ < 2) return 0;
  double result = 0;
  for (std::size_t i = 0; i < pixels_; ++i) {
    const double mean = luminanceSum_[i] / added_;
    result += (luminanceSquares_[i] - luminanceSum_[i] * mean) / (added_ - 1) * weight_[i];
  }
  return rootOf(result / judged_);
}

AccumulatedError ErrorMeter::accumulated(const Run& run) const {
  const double square = meanOf(run.squares);
  return {run.length, rootOf(square), rootInterval(square, standardError(partMeans(run.squares)))};
}

void ErrorMeter::fillRelative(ErrorSummary& summary) const {
  std::vector<double> errors(pixels_);
  for (std::size_t i = 0; i < pixels_ * 3; ++i) {
    const double r = reference_.mean.pixels[i];
    const double square = (squares_[i] - 2 * r * sum_[i]) / added_ + r * r;
    errors[i / 3] += square / (r * r + kRelMseFloor) / 3;
  }
  summary.relMse = meanOf(errors);
  summary.relMseMedian = median(errors);
  std::sort(errors.begin(), errors.end());
  errors.resize(errors.size() - std::size_t(std::ceil(double(errors.size()) * kTrimmed)));
  summary.relMseTrimmed = meanOf(errors);
}

ErrorSummary ErrorMeter::summary() const {
  ErrorSummary summary;
  summary.frames = added_;
  summary.notFinite = notFinite_;
  if (added_ == 0 || notFinite_ > 0) {
    summary.bias = summary.noise = summary.relMse = kInfinity;
    summary.relMseMedian = summary.relMseTrimmed = kInfinity;
    summary.biasInterval = {kInfinity, kInfinity};
    summary.accumulated.push_back({1, kInfinity, {kInfinity, kInfinity}});
    return summary;
  }
  fillBias(summary);
  summary.noise = noise();
  fillRelative(summary);
  for (const Run& run : runs_)
    if (!run.squares.empty()) summary.accumulated.push_back(accumulated(run));
  return summary;
}

ImageF ErrorMeter::meanPicture() const {
  ImageF result(reference_.mean.width, reference_.mean.height, 3);
  for (std::size_t i = 0; i < result.pixels.size(); ++i)
    result.pixels[i] = static_cast<float>(sum_[i] / std::max(added_, 1));
  return result;
}

}  // namespace orris
