#include <orris/chart/measure/combine.h>

#include <gmock/gmock.h>

#include <cmath>

namespace orris {
namespace {

using testing::ElementsAre;
using testing::SizeIs;

SettingResult seen(double bias, double cost, double baseline) {
  SettingResult result;
  result.label = "A=1";
  result.error = ErrorSummary{.frames = 8, .signedBias = bias, .bias = bias, .noise = 2 * bias};
  result.error->biasInterval = {bias / 2, bias * 2};
  result.error->accumulated = {{1, bias, {bias, bias}}, {2, bias, {bias, bias}}};
  result.error->relMse = bias;
  result.ssim = bias;
  result.pairs = {{cost, baseline}, {cost, baseline}};
  result.frames = {cost};
  result.passes = {{"deferred", {cost, cost, cost}}};
  return result;
}

TEST(Combine, OneCameraStaysAsItIs) {
  const SettingResult one = seen(0.3, 2, 1);
  EXPECT_EQ(combine({&one}), one);
}

TEST(Combine, ErrorsGoByTheirSquaresAndCostsByTheirSums) {
  SettingResult a = seen(0.3, 10, 10), b = seen(0.4, 50, 20);
  b.passes.push_back({"final", {6}});
  const SettingResult both = combine({&a, &b});
  const double rms = std::sqrt((0.09 + 0.16) / 2);
  EXPECT_NEAR(both.error->bias, rms, 1e-12);
  EXPECT_NEAR(both.error->biasInterval.low, rms / 2, 1e-12);
  EXPECT_NEAR(both.error->biasInterval.high, rms * 2, 1e-12);
  EXPECT_NEAR(both.error->noise, 2 * rms, 1e-12);
  EXPECT_NEAR(both.error->after(2).error, rms, 1e-12);
  EXPECT_NEAR(both.error->signedBias, 0.35, 1e-12);
  EXPECT_NEAR(both.error->relMse, 0.35, 1e-12);
  EXPECT_NEAR(both.ssim, 0.35, 1e-12);
  // (10 + 50) / (10 + 20), not the mean of 1 and 2.5.
  EXPECT_EQ(pairedCost(both.pairs).ratio, 2);
  EXPECT_THAT(both.frames, ElementsAre(10, 50));
  EXPECT_THAT(both.passes, ElementsAre(PassTimes{"deferred", {30}}, PassTimes{"final", {3}}));
}

TEST(Combine, WhatOneCameraLacksIsNotClaimed) {
  SettingResult a = seen(0.3, 10, 10), b = seen(0.4, 50, 20);
  b.pairs.pop_back();
  EXPECT_THAT(combine({&a, &b}).pairs, SizeIs(1));
  b.error.reset();
  b.pairs.clear();
  EXPECT_FALSE(combine({&a, &b}).error);
  EXPECT_THAT(combine({&a, &b}).pairs, SizeIs(0));
}

}  // namespace
}  // namespace orris
