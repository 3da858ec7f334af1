#include <orris/chart/measure/error_meter.h>

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <random>

namespace orris {
namespace {

ImageF flat(int width, int height, float value) {
  ImageF image(width, height, 3);
  std::fill(image.pixels.begin(), image.pixels.end(), value);
  return image;
}

ImageF noisy(int width, int height, double mean, double deviation, std::mt19937& random) {
  std::normal_distribution<double> noise(mean, deviation);
  ImageF image(width, height, 3);
  for (std::size_t i = 0; i < image.pixels.size(); i += 3) {
    const auto value = static_cast<float>(noise(random));
    for (std::size_t c = i; c < i + 3; ++c) image.pixels[c] = value;
  }
  return image;
}

ReferencePicture exact(int width, int height, float value) {
  const ImageF image = flat(width, height, value);
  return {image, image, image, true};
}

/// Over a reference of 1 the relative error is the error / 1.02.
constexpr double kScale = 1 / 1.02;

// A pixel on an edge is no error, whichever surface the frame took, and does not count among the pixels.
TEST(ErrorMeter, LeavesEdgesOut) {
  ReferencePicture reference = exact(4, 2, 1);
  ImageF picture = flat(4, 2, 1.5f);
  std::fill_n(picture.pixels.begin(), 6, 1000.0f);
  reference.edges = {1, 1, 0, 0, 0, 0, 0, 0};
  ErrorMeter meter(reference, 2);
  meter.add(picture);
  meter.add(picture);
  EXPECT_NEAR(meter.summary().bias / kScale, 0.5, 1e-6);
  EXPECT_NEAR(meter.summary().signedBias / kScale, 0.5, 1e-6);
  EXPECT_NEAR(meter.summary().after(2).error / kScale, 0.5, 1e-6);
  EXPECT_EQ(meter.summary().noise, 0);
}

// K = 16, variance 1, bias 0.05, 20000 pixels give .0030 +- .0006 for the squared
// bias; without taking off the noise of the mean .065.
TEST(ErrorMeter, TakesTheNoiseOfTheMeanOffTheBias) {
  std::mt19937 random(3);
  const ReferencePicture reference = exact(200, 100, 1);
  double sum = 0;
  constexpr int kTrials = 10;
  for (int trial = 0; trial < kTrials; ++trial) {
    ErrorMeter meter(reference, 16);
    for (int frame = 0; frame < 16; ++frame) meter.add(noisy(200, 100, 1.05, 1, random));
    const ErrorSummary summary = meter.summary();
    sum += std::pow(summary.bias / kScale, 2);
    EXPECT_NEAR(summary.noise / kScale, 1, 0.01);
    EXPECT_NEAR(summary.after(16).error / kScale, std::sqrt(0.0025 + 1.0 / 16), 0.006);
  }
  EXPECT_NEAR(sum / kTrials, 0.0025, 0.0006);
}

TEST(ErrorMeter, ErrorAfterNFramesIsBiasAndNoiseOverN) {
  std::mt19937 random(5);
  const ReferencePicture reference = exact(100, 100, 1);
  ErrorMeter meter(reference, 64);
  for (int frame = 0; frame < 64; ++frame) meter.add(noisy(100, 100, 1.3, 0.8, random));
  const ErrorSummary summary = meter.summary();
  ASSERT_EQ(summary.accumulated.size(), 7u);
  for (const AccumulatedError& run : summary.accumulated)
    EXPECT_NEAR(run.error / kScale, std::sqrt(0.09 + 0.64 / run.frames), 0.01) << run.frames;
  EXPECT_NEAR(summary.signedBias / kScale, 0.3, 0.005);
  EXPECT_LE(summary.biasInterval.low / kScale, 0.3);
  EXPECT_GE(summary.biasInterval.high / kScale, 0.3);
}

// The product of the errors against two halves holds no noise of the reference.
TEST(ErrorMeter, NoiseOfTheReferenceIsNoError) {
  std::mt19937 random(7);
  ReferencePicture reference;
  reference.first = noisy(200, 200, 1, 0.2, random);
  reference.second = noisy(200, 200, 1, 0.2, random);
  reference.mean = flat(200, 200, 1);
  reference.hasHalves = true;
  ErrorMeter meter(reference, 4);
  for (int frame = 0; frame < 4; ++frame) meter.add(flat(200, 200, 1.05f));
  EXPECT_NEAR(meter.summary().bias / kScale, 0.05, 0.006);
  EXPECT_NEAR(meter.summary().after(1).error / kScale, 0.05, 0.006);
  EXPECT_NEAR(noiseFloor(reference), 0.2 / std::sqrt(2), 0.003);
}

// A pack that reuses earlier frames: each frame is close to the one before. Frames counted as
// independent would claim that the mean is sure, and call its slow noise bias.
TEST(ErrorMeter, SlowNoiseIsNotTakenForBias) {
  std::mt19937 random(11);
  const ReferencePicture reference = exact(150, 150, 1);
  ErrorMeter meter(reference, 256);
  ImageF state = flat(150, 150, 1);
  for (int frame = -64; frame < 256; ++frame) {
    const ImageF fresh = noisy(150, 150, 1, 1, random);
    for (std::size_t i = 0; i < state.pixels.size(); ++i)
      state.pixels[i] = 0.8f * state.pixels[i] + 0.2f * fresh.pixels[i];
    if (frame >= 0) meter.add(state);
  }
  // Taken for independent the squared bias would be 1 / 256 * 8 / 9 = .0035, its root .059.
  EXPECT_LT(meter.summary().bias, 0.025);
  EXPECT_NEAR(meter.summary().noise / kScale, 1.0 / 3, 0.01);
}

TEST(ErrorMeter, RelMseIsThatOfCompareAndNamesTheFirefly) {
  const ReferencePicture reference = exact(50, 40, 0.5f);
  ErrorMeter meter(reference, 2);
  ImageF picture = flat(50, 40, 0.6f);
  picture.pixels[300] = picture.pixels[301] = picture.pixels[302] = 1000;
  meter.add(picture);
  meter.add(picture);
  const ErrorSummary summary = meter.summary();
  EXPECT_NEAR(summary.relMseMedian, 0.01 / 0.26, 1e-5);
  EXPECT_NEAR(summary.relMseTrimmed, 0.01 / 0.26, 1e-5);
  EXPECT_NEAR(summary.relMse, (1999 * 0.01 + 999.5 * 999.5) / 0.26 / 2000, 1e-1);
}

TEST(ErrorMeter, OneValueThatIsNoNumberSpoilsTheSetting) {
  const ReferencePicture reference = exact(8, 8, 1);
  ErrorMeter meter(reference, 2);
  ImageF picture = flat(8, 8, 1);
  meter.add(picture);
  picture.pixels[5] = std::numeric_limits<float>::quiet_NaN();
  meter.add(picture);
  EXPECT_EQ(meter.summary().notFinite, 1u);
  EXPECT_TRUE(std::isinf(meter.summary().bias));
  EXPECT_TRUE(std::isinf(meter.summary().after(1).error));
}

TEST(ErrorMeter, EqualPicturesHaveNoError) {
  const ReferencePicture reference = exact(8, 8, 0.25f);
  ErrorMeter meter(reference, 3);
  for (int frame = 0; frame < 3; ++frame) meter.add(flat(8, 8, 0.25f));
  const ErrorSummary summary = meter.summary();
  EXPECT_EQ(summary.bias, 0);
  EXPECT_EQ(summary.noise, 0);
  EXPECT_EQ(summary.after(1).error, 0);
  EXPECT_EQ(summary.after(1).interval, (Interval{0, 0}));
  EXPECT_NEAR(summary.relMse, 0, 1e-12);
}

}  // namespace
}  // namespace orris
