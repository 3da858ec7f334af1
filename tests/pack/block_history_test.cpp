#include <orris/pack/ids/block_history.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace orris {
namespace {

TEST(BlockHistory, names_come_and_go_with_versions_of_the_game) {
  const BlockLife* grass = findBlockLife("grass");
  ASSERT_NE(grass, nullptr);
  EXPECT_TRUE(grass->existsIn({1, 16, 5}));
  EXPECT_TRUE(grass->existsIn({1, 20, 2}));
  EXPECT_FALSE(grass->existsIn({1, 20, 3}));
  EXPECT_FALSE(findBlockLife("short_grass")->existsIn({1, 20, 2}));
  EXPECT_TRUE(findBlockLife("short_grass")->existsIn({1, 20, 3}));
  EXPECT_TRUE(findBlockLife("cherry_leaves")->existsIn({1, 19, 4}));
  EXPECT_FALSE(findBlockLife("stained_glass")->existsIn({1, 13, 0}));
  EXPECT_FALSE(findBlockLife("golden_dandelion")->existsIn({1, 21, 11}));
  EXPECT_TRUE(findBlockLife("golden_dandelion")->existsIn({26, 1, 0}));
}

TEST(BlockHistory, no_version_has_a_misspelt_name) {
  EXPECT_EQ(findBlockLife("oak_leafs"), nullptr);
  EXPECT_EQ(findBlockLife("minecraft:stone"), nullptr);
  EXPECT_EQ(findBlockLife(""), nullptr);
}

TEST(BlockHistory, all_names_are_sorted_and_each_is_there_once) {
  const auto& names = allBlockNames();
  EXPECT_GT(names.size(), 1200u);
  EXPECT_TRUE(std::is_sorted(names.begin(), names.end()));
  EXPECT_EQ(std::adjacent_find(names.begin(), names.end()), names.end());
}

}  // namespace
}  // namespace orris
