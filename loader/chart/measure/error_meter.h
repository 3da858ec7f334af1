// How far the pictures of one setting are from the reference: what stays however many frames are averaged
// (bias), and what changes from frame to frame (noise).
#pragma once

#include <cstddef>
#include <vector>

#include <orris/chart/measure/reference_picture.h>
#include <orris/chart/measure/statistics.h>

namespace orris {

/// Error of the mean of so many frames in a row.
struct AccumulatedError {
  int frames = 1;
  double error = 0;  ///< rms, as in ErrorSummary
  Interval interval;
  bool operator==(const AccumulatedError&) const = default;
};

/// "rms" is over the pixels of the luminance error (x - r) / (r + 0.02 * mean of r). Noise of the
/// reference is not in it where the reference has halves.
struct ErrorSummary {
  int frames = 0;
  double signedBias = 0;                      ///< mean over the pixels
  double bias = 0;                            ///< rms; what is explained by noise is taken off
  Interval biasInterval;                      ///< of two standard errors
  double noise = 0;                           ///< rms of a pixel's standard deviation over frames
  std::vector<AccumulatedError> accumulated;  ///< for 1, 2, 4 ... frames
  double relMse =
      0;  ///< of one frame, by channel: mean of (x-r)^2 / (r^2 + 0.01), as orris compare
  double relMseMedian = 0, relMseTrimmed = 0;  ///< over pixels; without the worst thousandth
  std::size_t notFinite = 0;  ///< pixels of all frames; then all errors are infinite

  /// Error of the mean of `count` frames: of the longest run measured that is not longer.
  const AccumulatedError& after(int count) const;
  bool operator==(const ErrorSummary&) const = default;
};

class ErrorMeter {
 public:
  /// For `frames` pictures of the size of `reference`, which must outlive this.
  ErrorMeter(const ReferencePicture& reference, int frames);

  /// The next picture, linear, as large as the reference.
  void add(const ImageF& picture);
  ErrorSummary summary() const;
  ImageF meanPicture() const;  ///< of all frames so far

 private:
  /// Runs of `length` frames: the sum of the one that is not full, and the errors of the full ones.
  struct Run {
    int length = 1, filled = 0;
    std::vector<double> sum;
    std::vector<double> squares;  ///< mean squared error of each
  };
  void addToRuns(const std::vector<double>& luminance);
  double squaredError(const std::vector<double>& sum, double count) const;
  double squaredBias(const std::vector<const std::vector<double>*>& batches) const;
  AccumulatedError accumulated(const Run& run) const;
  void fillBias(ErrorSummary& summary) const;
  double noise() const;
  void fillRelative(ErrorSummary& summary) const;

  const ReferencePicture& reference_;
  int frames_, added_ = 0;
  std::size_t pixels_, notFinite_ = 0;
  double judged_ = 0;                            ///< pixels that are not undecided
  std::vector<double> first_, second_, weight_;  ///< luminance of the halves; 1 / (r + 0.02 mean)^2
  std::vector<double> sum_, squares_;            ///< by channel
  std::vector<double> luminanceSum_, luminanceSquares_;
  std::vector<std::vector<double>> batches_;  ///< sums of luminance
  std::vector<int> batchFrames_;
  std::vector<Run> runs_;
};

}  // namespace orris
