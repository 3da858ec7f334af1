#include <orris/chart/measure/statistics.h>

#include <gmock/gmock.h>

#include <cmath>
#include <random>

namespace orris {
namespace {

TEST(Statistics, QuantilesLieBetweenNeighbours) {
  EXPECT_EQ(median({}), 0);
  EXPECT_EQ(median({7}), 7);
  EXPECT_EQ(median({3, 1, 2}), 2);
  EXPECT_EQ(median({4, 1, 3, 2}), 2.5);
  EXPECT_EQ(quantile({10, 20, 30, 40, 50}, 0.95), 48);
  EXPECT_EQ(quantile({1, 2}, 1), 2);
  EXPECT_EQ(quantile({1, 2}, 0), 1);
}

TEST(Statistics, TheIntervalOfTheMedianHoldsIt) {
  std::mt19937 random(2);
  std::normal_distribution<double> noise(1, 0.1);
  int held = 0;
  double width = 0;
  constexpr int kMedians = 300, kValues = 40;
  for (int trial = 0; trial < kMedians; ++trial) {
    std::vector<double> values(kValues);
    for (double& value : values) value = noise(random);
    const Interval interval = bootstrapMedian(values);
    held += interval.low <= 1 && 1 <= interval.high ? 1 : 0;
    width += (interval.high - interval.low) / kMedians;
  }
  EXPECT_GE(held, 0.91 * kMedians);
  EXPECT_LE(held, 0.99 * kMedians);
  // Two sides of 1.96 standard errors of a median: sqrt(pi / 2) of those of a mean.
  EXPECT_NEAR(width, 2 * 1.96 * 0.1 * std::sqrt(1.5708 / kValues), 0.012);
}

TEST(Statistics, TheSameValuesGiveTheSameInterval) {
  const std::vector<double> values = {1, 3, 2, 8, 5};
  EXPECT_EQ(bootstrapMedian(values), bootstrapMedian(values));
  EXPECT_EQ(bootstrapMedian({4}), (Interval{4, 4}));
}

/// The noise of a shared machine: 3 % jitter, 7 % slow drift, 2 % of spikes.
class Machine {
 public:
  explicit Machine(unsigned seed) : random_(seed) {}
  double run(double cost) {
    const double drift = 1 + 0.07 * std::sin(0.01 * clock_++);
    const double spike = chance_(random_) < 0.02 ? 3 : 1;
    return cost * drift * spike * (1 + 0.03 * jitter_(random_));
  }

 private:
  std::mt19937 random_;
  std::normal_distribution<double> jitter_;
  std::uniform_real_distribution<double> chance_;
  int clock_ = 0;
};

double spreadOf(int rounds, int trials) {
  double squares = 0;
  for (int trial = 0; trial < trials; ++trial) {
    Machine machine(unsigned(trial) + 1);
    std::vector<TimePair> pairs;
    for (int round = 0; round < rounds; ++round) {  // A B B A
      double a = machine.run(10);
      const double b = machine.run(10.3) + machine.run(10.3);
      a += machine.run(10);
      pairs.push_back({b / 2, a / 2});
    }
    squares += std::pow(pairedCost(pairs).ratio - 1.03, 2);
  }
  return std::sqrt(squares / trials);
}

TEST(PairedCost, RatioIsAsSureAsPredicted) {
  EXPECT_LT(spreadOf(50, 40), 0.0075);   // 100 frames each: .0056
  EXPECT_LT(spreadOf(150, 20), 0.0045);  // 300: .0033
}

TEST(PairedCost, OneSpikeChangesNothing) {
  const PairedCost cost = pairedCost({{2, 1}, {2, 1}, {200, 1}, {2, 1}, {2, 100}, {4, 2}, {6, 3}});
  EXPECT_EQ(cost.ratio, 2);
  EXPECT_EQ(cost.median, 2);
  EXPECT_EQ(cost.pairs, 7u);
}

TEST(PairedCost, WithoutPairsNothingIsClaimed) {
  EXPECT_EQ(pairedCost({}).pairs, 0u);
  EXPECT_EQ(pairedCost({}).median, 0);
  EXPECT_EQ(pairedCost({{1, 0}}).ratio, 1);
}

}  // namespace
}  // namespace orris
