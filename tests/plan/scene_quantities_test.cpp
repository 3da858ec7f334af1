// What options choose by is what a scene has.
#include <orris/plan/scene/scene_quantities.h>

#include <gtest/gtest.h>

#include "plan/lamp_floor.h"

namespace orris {
namespace {

Quantities measured(World world, int size = 32) {
  Diagnostics diagnostics;
  const Camera camera = world.cameras.front();
  const SceneData scene = buildScene(std::move(world), {}, diagnostics);
  PackDirectives directives;
  directives.shadowDistance = 64;
  const FrameState view = nextFrameState(
      {.width = size, .height = size, .camera = camera, .environment = scene.world.environment},
      directives, nullptr);
  std::set<std::string> all;
  for (const SceneQuantity& quantity : sceneQuantities()) all.emplace(quantity.name);
  return measureScene(scene, view, directives, all);
}

TEST(SceneQuantities, of_a_floor_under_the_sky) {
  const Quantities floor = measured(lampFloor(0));
  EXPECT_EQ(floor.size(), sceneQuantities().size());
  EXPECT_EQ(floor.at("pixels"), 1024);
  // Top and bottom of 16 x 16 blocks, and four sides.
  EXPECT_EQ(floor.at("faces"), 2 * 256 + 4 * 16);
  EXPECT_EQ(floor.at("casters"), floor.at("faces"));
  EXPECT_EQ(floor.at("extent"), 16);
  EXPECT_GT(floor.at("casters_near"), 100);
  EXPECT_LT(floor.at("casters_near"), 300);
  EXPECT_EQ(floor.at("lamps"), 0);
  EXPECT_EQ(floor.at("lamps_reaching"), 0);
  EXPECT_EQ(floor.at("sun"), 1);
  // A box: the sides of its volume are few.
  EXPECT_GT(floor.at("volumes"), 3);
  EXPECT_LT(floor.at("volumes"), 100);
  // From 4.5 blocks away with 70 degrees, 32 pixels are 6.3 blocks, and a texel an eighth of one.
  EXPECT_NEAR(floor.at("texel_pixels"), 0.125 * 32 / 6.3, 0.1);
  EXPECT_EQ(measured(lampFloor(0), 64).at("pixels"), 4096);
}

TEST(SceneQuantities, lamps_reach_as_far_as_their_level) {
  const Quantities many = measured(lampFloor(20));
  EXPECT_EQ(many.at("lamps"), 20);
  EXPECT_NEAR(many.at("lamps_reaching"), 20, 0.01) << "level 15, and nothing is farther than 8";
  const Quantities dim = measured(lampFloor(1, "minecraft:magma_block"));
  EXPECT_EQ(dim.at("lamps"), 1);
  EXPECT_LT(dim.at("lamps_reaching"), 0.3) << "level 3, and at the border of what is seen";
}

double glassOf(const char* block) {
  World world = lampFloor(0);
  world.blocks.set({0, 3, 0}, world.blocks.paletteIndex(*parseBlockState(block)));
  return measured(std::move(world)).at("glass");
}

TEST(SceneQuantities, glass_is_what_is_translucent_but_water) {
  EXPECT_EQ(glassOf("minecraft:red_stained_glass"), 6);
  EXPECT_EQ(glassOf("minecraft:ice"), 6);
  EXPECT_EQ(glassOf("minecraft:glass"), 0) << "a cutout";
  EXPECT_EQ(glassOf("minecraft:water"), 0);
}

TEST(SceneQuantities, no_sun_comes_into_a_closed_room) {
  World room = lampFloor(1);
  const auto stone = room.blocks.paletteIndex(*parseBlockState("minecraft:stone"));
  World closed;
  closed.blocks = BlockWorld({-8, 0, -8}, {16, 12, 16});
  closed.blocks.fill({-8, 0, -8}, {7, 11, 7},
                     closed.blocks.paletteIndex(room.blocks.palette()[stone]));
  closed.blocks.fill({-6, 2, -6}, {5, 9, 5}, 0);
  closed.cameras = room.cameras;
  EXPECT_EQ(measured(std::move(closed)).at("sun"), 0);
}

}  // namespace
}  // namespace orris
