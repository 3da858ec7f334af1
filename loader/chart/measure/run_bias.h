// How far pictures are from a reference for good, from several runs that share no random number.
#pragma once

#include <array>
#include <vector>

#include <orris/chart/measure/reference_picture.h>
#include <orris/chart/measure/statistics.h>

namespace orris {

/// Of one channel. Intervals are of 95 % and hold the noise of the runs, correlated over pixels and frames as it may be,
/// and that of the reference.
struct ChannelBias {
  double signedMean = 0;  ///< mean over the pixels of (x - r) / (r + kDarkShare * mean of r)
  Interval signedInterval;
  /// Mean over the pixels of the squared bias: of products of different runs against different halves of the
  /// reference. Unbiased, so it may come out below 0 where there is none.
  double square = 0;
  Interval squareInterval;
  double drift = 0;  ///< of signedMean, from the first half of the frames of a run to the second
  Interval driftInterval;
};

/// Red, green, blue, luminance.
inline constexpr std::size_t kBiasChannels = 4;
using RunBias = std::array<ChannelBias, kBiasChannels>;

/// The means of the two halves of the frames of one run.
struct RunMeans {
  ImageF first, second;
};

/// Three runs at least, each begun anew with its own random numbers. Without halves of the reference its noise counts
/// as bias.
RunBias biasOfRuns(const std::vector<RunMeans>& runs, const ReferencePicture& reference);

/// Root of a mean square; of one below 0 the negative root of its size, so that it is seen.
double signedRoot(double square);

}  // namespace orris
