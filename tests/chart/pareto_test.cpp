#include <orris/chart/page/pareto.h>

#include <gmock/gmock.h>

#include <limits>

namespace orris {
namespace {

using testing::ElementsAre;

TEST(ParetoFront, KeepsWhatNothingBeats) {
  EXPECT_THAT(paretoFront({{4, 1}, {1, 4}, {2, 2}, {3, 3}, {2, 5}}),
              ElementsAre(true, true, true, false, false));
}

TEST(ParetoFront, AsGoodForMoreIsBeaten) {
  EXPECT_THAT(paretoFront({{1, 2}, {2, 2}}), ElementsAre(true, false));
  EXPECT_THAT(paretoFront({{1, 3}, {1, 2}}), ElementsAre(false, true));
}

TEST(ParetoFront, EqualPointsStandTogether) {
  EXPECT_THAT(paretoFront({{1, 2}, {3, 1}, {1, 2}, {3, 1}}), ElementsAre(true, true, true, true));
  EXPECT_THAT(paretoFront({{2, 2}, {2, 2}, {1, 1}}), ElementsAre(false, false, true));
}

TEST(ParetoFront, WhatIsNoNumberIsNeverOnIt) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_THAT(paretoFront({{1, infinity}, {0.5, std::numeric_limits<double>::quiet_NaN()}, {2, 3}}),
              ElementsAre(false, false, true));
  EXPECT_TRUE(paretoFront({}).empty());
}

}  // namespace
}  // namespace orris
