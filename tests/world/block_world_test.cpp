#include <orris/world/blocks/block_world.h>

#include <gtest/gtest.h>

namespace orris {
namespace {

const BlockState kStone{"minecraft:stone", {}};

TEST(BlockWorld, starts_as_air_and_is_air_outside) {
  BlockWorld world({-2, 5, 3}, {4, 2, 3});
  EXPECT_EQ(world.at({-2, 5, 3}).name, "minecraft:air");
  const std::uint32_t stone = world.paletteIndex(kStone);
  world.fill({-100, -100, -100}, {100, 100, 100}, stone);
  EXPECT_EQ(world.at({1, 6, 5}), kStone);
  EXPECT_EQ(world.indexAt({2, 6, 5}), 0u);
  EXPECT_EQ(world.indexAt({-2, 4, 3}), 0u);
}

TEST(BlockWorld, palette_holds_each_state_once) {
  BlockWorld world({0, 0, 0}, {1, 1, 1});
  EXPECT_EQ(world.paletteIndex({"minecraft:air", {}}), 0u);
  EXPECT_EQ(world.paletteIndex(kStone), 1u);
  EXPECT_EQ(world.paletteIndex(kStone), 1u);
  EXPECT_EQ(world.palette().size(), 2u);
}

TEST(BlockWorld, fill_takes_corners_in_any_order_and_touches_nothing_else) {
  BlockWorld world({0, 0, 0}, {4, 4, 4});
  world.fill({2, 3, 1}, {1, 2, 1}, world.paletteIndex(kStone));
  int count = 0;
  for (int i = 0; i < 64; ++i) count += world.indexAt({i % 4, i / 16, i / 4 % 4}) != 0;
  EXPECT_EQ(count, 4);
  EXPECT_EQ(world.at({1, 2, 1}), kStone);
  EXPECT_EQ(world.at({2, 3, 1}), kStone);
}

TEST(BlockWorld, setting_outside_is_ignored) {
  BlockWorld world({0, 0, 0}, {1, 1, 1});
  world.set({0, 1, 0}, world.paletteIndex(kStone));
  world.fill({5, 5, 5}, {6, 6, 6}, 1);
  EXPECT_EQ(world.indexAt({0, 0, 0}), 0u);
}

}  // namespace
}  // namespace orris
