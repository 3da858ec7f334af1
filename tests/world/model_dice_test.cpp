// The table was made by a second implementation, in whole numbers of any size.
#include <orris/world/mesh/model_dice.h>

#include <gtest/gtest.h>

#include <array>

namespace orris {
namespace {

struct Throw {
  glm::ivec3 cell;
  std::size_t ofFour, ofFourInParts, sevenTwoOne;
};
constexpr Throw kThrows[] = {
    {{0, 0, 0}, 0, 3, 0},          {{1, 0, 0}, 1, 3, 2},
    {{0, 1, 0}, 0, 1, 0},          {{0, 0, 1}, 3, 0, 1},
    {{-1, -1, -1}, 0, 3, 0},       {{100, 64, -200}, 1, 0, 0},
    {{15, 70, 15}, 3, 3, 1},       {{-30000000, 319, 29999999}, 1, 1, 0},
    {{1234, -60, -4321}, 0, 0, 0},
};

TEST(model_dice, a_place_has_the_games_alternative) {
  for (const Throw& expected : kThrows) {
    EXPECT_EQ(ModelDice(expected.cell, false).choose({1, 1, 1, 1}), expected.ofFour);
    EXPECT_EQ(ModelDice(expected.cell, true).choose({1, 1, 1, 1}), expected.ofFourInParts);
    EXPECT_EQ(ModelDice(expected.cell, false).choose({7, 2, 1}), expected.sevenTwoOne);
  }
}

TEST(model_dice, alternatives_come_as_often_as_their_weights_say) {
  std::array<int, 3> counts{};
  for (int x = 0; x < 40; ++x)
    for (int y = 0; y < 10; ++y)
      for (int z = 0; z < 40; ++z) ++counts[ModelDice({x, y, z}, false).choose({5, 3, 2})];
  EXPECT_NEAR(counts[0] / 16000.0, 0.5, 0.02);
  EXPECT_NEAR(counts[1] / 16000.0, 0.3, 0.02);
}

}  // namespace
}  // namespace orris
