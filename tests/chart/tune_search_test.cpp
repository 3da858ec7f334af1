#include <orris/chart/study/tune_search.h>

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

namespace orris {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const TuneGoal kError{0.1, 0};
const TuneGoal kTime{std::nullopt, 5};

TEST(TuneGoal, TakesTheCheapestWithinAnError) {
  const std::vector<Tried> tried = {CostError{1, 0.5}, CostError{4, 0.1}, CostError{3, 0.09},
                                    std::nullopt, CostError{9, 0.01}};
  EXPECT_EQ(bestOf(tried, kError), 2u);
  EXPECT_EQ(bestOf(tried, TuneGoal{0.001, 0}), std::nullopt);
  EXPECT_EQ(nearestTo(tried, TuneGoal{0.001, 0}), 4u);
}

TEST(TuneGoal, TakesTheMostAccurateWithinATime) {
  const std::vector<Tried> tried = {CostError{1, 0.5}, CostError{5, 0.1}, CostError{4, 0.1},
                                    CostError{9, 0.01}};
  EXPECT_EQ(bestOf(tried, kTime), 2u);
  EXPECT_EQ(bestOf(tried, TuneGoal{std::nullopt, 0.5}), std::nullopt);
  EXPECT_EQ(nearestTo(tried, TuneGoal{std::nullopt, 0.5}), 0u);
}

TEST(TuneGoal, WhatCannotBeDrawnIsNeverTaken) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(bestOf({CostError{none, none}, CostError{2, 0.05}}, kError), 1u);
  EXPECT_EQ(nearestTo({CostError{none, none}}, kError), std::nullopt);
  EXPECT_EQ(nearestTo({std::nullopt}, kTime), std::nullopt);
}

/// Three axes A, B, C of `n` values each.
std::vector<Setting> grid(int n) {
  std::vector<Setting> settings;
  for (int a = 0; a < n; ++a)
    for (int b = 0; b < n; ++b)
      for (int c = 0; c < n; ++c)
        settings.push_back({.profile = {},
                            .values = {{"A", std::to_string(a)},
                                       {"B", std::to_string(b)},
                                       {"C", std::to_string(c)}},
                            .size = {1, 1}});
  return settings;
}

TEST(TuneSearch, TriesAllOfAFew) {
  const std::vector<Setting> settings = grid(2);
  std::vector<Tried> tried(8);
  EXPECT_THAT(nextToTry(settings, tried, kError), ElementsAre(0, 1, 2, 3, 4, 5, 6, 7));
  tried[3] = CostError{1, 1};
  EXPECT_THAT(nextToTry(settings, tried, kError), ElementsAre(0, 1, 2, 4, 5, 6, 7));
}

/// A costs and helps most, B less; C only costs.
CostError price(const Setting& setting) {
  const double a = std::stod(setting.values.at("A")), b = std::stod(setting.values.at("B")),
               c = std::stod(setting.values.at("C"));
  return {1 + 4 * a + 1.5 * b + c, 1 / (1 + 3 * a + b)};
}

std::size_t searchAll(const std::vector<Setting>& settings, const TuneGoal& goal,
                      std::vector<Tried>& tried) {
  tried.assign(settings.size(), std::nullopt);
  std::size_t measured = 0;
  for (auto next = nextToTry(settings, tried, goal); !next.empty();
       next = nextToTry(settings, tried, goal)) {
    measured += next.size();
    for (const std::size_t i : next) tried[i] = price(settings[i]);
  }
  return measured;
}

TEST(TuneSearch, FindsTheBestOfManyWithoutTryingAll) {
  const std::vector<Setting> settings = grid(6);
  std::vector<Tried> all, tried;
  for (const Setting& setting : settings) all.emplace_back(price(setting));
  for (const TuneGoal& goal : {TuneGoal{0.09, 0}, TuneGoal{0.3, 0}, TuneGoal{std::nullopt, 12},
                               TuneGoal{std::nullopt, 4}}) {
    const std::size_t measured = searchAll(settings, goal, tried);
    ASSERT_TRUE(bestOf(tried, goal));
    EXPECT_EQ(bestOf(tried, goal), bestOf(all, goal));
    EXPECT_LT(measured, settings.size() / 2);
  }
}

TEST(TuneSearch, EndsWhereNothingCanBeDrawn) {
  const std::vector<Setting> settings = grid(3);
  std::vector<Tried> tried(settings.size());
  const double none = std::numeric_limits<double>::quiet_NaN();
  for (const std::size_t i : nextToTry(settings, tried, kError)) tried[i] = CostError{none, none};
  EXPECT_THAT(nextToTry(settings, tried, kError), IsEmpty());
}

TEST(TuneSearch, CountsTheAxesInWhichSettingsDiffer) {
  Setting a{.profile = "X", .values = {{"A", "1"}, {"B", "1"}}, .size = {1, 1}}, b = a;
  EXPECT_EQ(differences(a, b), 0);
  b.values["B"] = "2";
  EXPECT_EQ(differences(a, b), 1);
  b.size = {2, 1};
  b.profile = "Y";
  EXPECT_EQ(differences(a, b), 3);
}

}  // namespace
}  // namespace orris
