#include <orris/world/mesh/light.h>

#include <gtest/gtest.h>

#include "world_helpers.h"

namespace orris {
namespace {

TEST(Light, torch_light_falls_by_one_a_step_in_a_closed_room) {
  Scene scene({17, 17, 17});
  scene.fill({0, 0, 0}, {16, 16, 16}, "stone");
  scene.fill({1, 1, 1}, {15, 15, 15}, "air");
  scene.set({8, 8, 8}, "torch");
  const LightLevels light = scene.light();
  for (int x = 1; x < 16; ++x) {
    for (int y = 1; y < 16; ++y) {
      const int distance = std::abs(x - 8) + std::abs(y - 8) + 2;
      EXPECT_EQ(light.block({x, y, 10}), std::max(0, 14 - distance));
    }
  }
  EXPECT_EQ(light.block({8, 8, 8}), 14);
  EXPECT_EQ(light.sky({8, 15, 8}), 0);
}

TEST(Light, without_skylight_all_is_dark_but_for_lamps) {
  Scene scene({4, 4, 4});
  scene.set({1, 1, 1}, "torch");
  const LightLevels light(scene.blocks, scene.facts(), false);
  EXPECT_EQ(light.sky({3, 3, 3}), 0);
  EXPECT_EQ(light.sky({3, 30, 3}), 0);
  EXPECT_EQ(light.block({1, 1, 2}), 13);
}

TEST(Light, light_goes_round_a_wall) {
  Scene scene({3, 1, 5});
  scene.set({0, 0, 0}, "sea_lantern");
  scene.fill({0, 0, 2}, {1, 0, 2}, "stone");
  const LightLevels light = scene.light();
  // Over the top of the wall, through the ring of air around the box: 6 steps.
  EXPECT_EQ(light.block({0, 0, 4}), 15 - 6);
  EXPECT_EQ(light.block({0, 0, 2}), 0) << "inside stone";
}

TEST(Light, water_and_leaves_take_one_level_a_block_from_the_sky) {
  Scene scene({9, 6, 9});
  scene.fill({0, 0, 0}, {8, 0, 8}, "stone");
  scene.fill({1, 1, 1}, {7, 4, 7}, "water");
  const LightLevels light = scene.light();
  EXPECT_EQ(light.sky({4, 5, 4}), 15);
  EXPECT_EQ(light.sky({4, 4, 4}), 14);
  EXPECT_EQ(light.sky({4, 3, 4}), 13);
  EXPECT_EQ(light.sky({4, 1, 4}), 11);
  EXPECT_EQ(light.sky({4, 0, 4}), 0);
}

TEST(Light, sky_reaches_under_an_overhang_from_its_side) {
  Scene scene({9, 5, 9});
  scene.fill({0, 0, 0}, {8, 0, 8}, "stone");
  scene.fill({0, 3, 0}, {8, 3, 8}, "stone");
  const LightLevels light = scene.light();
  EXPECT_EQ(light.sky({4, 4, 4}), 15);
  EXPECT_EQ(light.sky({0, 2, 4}), 14);
  EXPECT_EQ(light.sky({4, 1, 4}), 10);
}

TEST(Light, stairs_and_slabs_close_a_roof) {
  for (const char* roof : {"oak_slab[type=bottom]", "oak_slab[type=top]", "oak_stairs[facing=east]",
                           "oak_stairs[facing=east,half=top]"}) {
    Scene scene({5, 4, 5});
    scene.fill({0, 0, 0}, {4, 3, 4}, "stone");
    scene.fill({1, 1, 1}, {3, 2, 3}, "air");
    scene.set({2, 3, 2}, roof);
    const LightLevels light = scene.light();
    EXPECT_EQ(light.sky({2, 2, 2}), 0) << roof;
    const bool topClosed = std::string(roof).find("top") != std::string::npos;
    EXPECT_EQ(light.sky({2, 3, 2}), topClosed ? 0 : 15) << roof;
  }
}

TEST(Light, lamp_behind_a_slab_shines_past_its_open_half_only) {
  Scene scene({5, 3, 3});
  scene.fill({0, 0, 0}, {4, 2, 2}, "stone");
  scene.set({1, 1, 1}, "glowstone");
  scene.set({2, 1, 1}, "oak_stairs[facing=east]");
  scene.set({3, 1, 1}, "air");
  const LightLevels light = scene.light();
  EXPECT_EQ(light.block({2, 1, 1}), 14) << "the open front";
  EXPECT_EQ(light.block({3, 1, 1}), 0) << "behind the closed back";
}

TEST(Light, glass_lets_the_sky_straight_through) {
  Scene scene({5, 4, 5});
  scene.fill({0, 0, 0}, {4, 3, 4}, "stone");
  scene.fill({1, 1, 1}, {3, 2, 3}, "air");
  scene.fill({1, 3, 1}, {3, 3, 3}, "glass");
  EXPECT_EQ(scene.light().sky({2, 1, 2}), 15);
}

TEST(Light, outside_the_box_is_open_sky) {
  Scene scene({1, 1, 1});
  scene.set({0, 0, 0}, "glowstone");
  const LightLevels light = scene.light();
  EXPECT_EQ(light.sky({50, 0, 0}), 15);
  EXPECT_EQ(light.block({50, 0, 0}), 0);
  EXPECT_EQ(light.block({1, 0, 0}), 14) << "the ring around the box is lit";
}

}  // namespace
}  // namespace orris
