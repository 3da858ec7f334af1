// The bias of independent runs, on pictures whose bias and noise are known.
#include <orris/chart/measure/run_bias.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace orris {
namespace {

constexpr int kWidth = 8, kHeight = 6, kTrials = 1000;
constexpr double kLight = 0.5;

/// Bias of every third pixel is -1/2 of that of the others.
double shareOf(int pixel) { return pixel % 3 == 0 ? -0.5 : 1; }

struct Case {
  double bias;
  double common;  ///< noise of a run that whole parts of its picture share
  double own;     ///< of each pixel, against the other window of the run half undone: anticorrelated frames
  double reference;
  int runs;
};

class Pictures {
 public:
  explicit Pictures(std::uint32_t seed) : random_(seed) {}

  ReferencePicture reference(double noise) {
    ReferencePicture result;
    result.first = grey([&](int) { return noise * normal_(random_); });
    result.second = grey([&](int) { return noise * normal_(random_); });
    result.mean = ImageF(kWidth, kHeight, 3);
    for (std::size_t i = 0; i < result.mean.pixels.size(); ++i)
      result.mean.pixels[i] = float(kLight);
    result.hasHalves = true;
    return result;
  }

  RunMeans run(const Case& c) {
    double part[4], own[kWidth * kHeight];
    for (double& value : part) value = c.common * normal_(random_);
    for (double& value : own) value = c.own * normal_(random_);
    const auto error = [&](int i) { return c.bias * shareOf(i) + part[i * 4 / (kWidth * kHeight)]; };
    return {grey([&](int i) { return error(i) + 1.5 * own[i]; }),
            grey([&](int i) { return error(i) - 0.5 * own[i]; })};
  }

 private:
  template <class Error>
  static ImageF grey(const Error& error) {
    ImageF image(kWidth, kHeight, 3);
    for (int i = 0; i < kWidth * kHeight; ++i) {
      const auto value = float(kLight + error(i));
      for (std::size_t c = 0; c < 3; ++c) image.pixels[std::size_t(i) * 3 + c] = value;
    }
    return image;
  }

  std::mt19937 random_;
  std::normal_distribution<double> normal_;
};

/// In how many of the trials the intervals hold what is true.
struct Held {
  double signedMean = 0, square = 0, meanSquare = 0;
};

Held heldOf(const Case& c) {
  Pictures pictures(7);
  const double scale = kLight * (1 + kDarkShare);
  double mean = 0, square = 0;
  for (int i = 0; i < kWidth * kHeight; ++i) {
    mean += c.bias * shareOf(i) / scale / (kWidth * kHeight);
    square += std::pow(c.bias * shareOf(i) / scale, 2) / (kWidth * kHeight);
  }
  Held held;
  for (int trial = 0; trial < kTrials; ++trial) {
    const ReferencePicture reference = pictures.reference(c.reference);
    std::vector<RunMeans> runs;
    for (int k = 0; k < c.runs; ++k) runs.push_back(pictures.run(c));
    const ChannelBias found = biasOfRuns(runs, reference)[1];
    held.signedMean += (found.signedInterval.low <= mean && mean <= found.signedInterval.high);
    held.square += (found.squareInterval.low <= square && square <= found.squareInterval.high);
    held.meanSquare += (found.square - square) / kTrials;
  }
  held.signedMean /= kTrials;
  held.square /= kTrials;
  return held;
}

TEST(RunBias, intervals_hold_the_bias_in_95_of_100_cases) {
  for (const Case& c : {Case{.05, .01, .03, .01, 4}, {.05, .01, .03, .01, 8}, {.03, .03, .02, .01, 8}}) {
    const Held held = heldOf(c);
    EXPECT_GE(held.signedMean, .93) << c.bias << " " << c.runs;
    EXPECT_LE(held.signedMean, .97) << c.bias << " " << c.runs;
    EXPECT_GE(held.square, .93) << c.bias << " " << c.runs;
    EXPECT_LE(held.square, .97) << c.bias << " " << c.runs;
    EXPECT_NEAR(held.meanSquare, 0, 1e-4) << c.bias << " " << c.runs;
  }
}

// With next to no bias the square is that of noise alone, whose intervals are rather too wide.
TEST(RunBias, no_bias_is_not_found_where_there_is_none) {
  const Held held = heldOf({0, .01, .03, .02, 8});
  EXPECT_GE(held.signedMean, .93);
  EXPECT_LE(held.signedMean, .97);
  EXPECT_GE(held.square, .93);
  EXPECT_NEAR(held.meanSquare, 0, 5e-5);
}

TEST(RunBias, a_square_below_zero_is_shown) {
  EXPECT_NEAR(signedRoot(-0.0004), -0.02, 1e-12);
  EXPECT_NEAR(signedRoot(0.0009), 0.03, 1e-12);
}

TEST(RunBias, channels_and_drift_are_kept_apart) {
  ReferencePicture reference = Pictures(1).reference(0);
  RunMeans run{reference.first, reference.second};
  for (std::size_t i = 0; i < run.first.pixels.size(); ++i) {
    run.first.pixels[i] = float(kLight * (i % 3 == 0 ? 1.1 : 1));
    run.second.pixels[i] = float(kLight * (i % 3 == 0 ? 1.3 : 1));
  }
  const RunBias bias = biasOfRuns({run, run, run}, reference);
  EXPECT_NEAR(bias[0].signedMean, 0.2 / 1.02, 1e-6);
  EXPECT_NEAR(bias[0].drift, 0.2 / 1.02, 1e-6);
  EXPECT_NEAR(bias[1].signedMean, 0, 1e-6);
  EXPECT_NEAR(bias[3].signedMean, 0.2126 * 0.2 / 1.02, 1e-6);
  EXPECT_NEAR(signedRoot(bias[0].square), 0.2 / 1.02, 1e-6);
}

}  // namespace
}  // namespace orris
