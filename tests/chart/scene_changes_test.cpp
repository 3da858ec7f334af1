#include <orris/chart/scenes/scene_changes.h>

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <set>

namespace orris {
namespace {

/// Air of 5^3 cells with the eye in the middle, and an event of its own.
World smallWorld() {
  World world;
  world.blocks = BlockWorld(glm::ivec3(0), glm::ivec3(5));
  world.cameras = {{"eye", {2.5, 2.5, 2.5}, 30, 10}};
  world.events = {{1, SetTime{6000}}};
  return world;
}

TEST(SceneChanges, walking_moves_the_camera_by_the_steps_of_a_player_and_nothing_else) {
  const World world = smallWorld();
  const Camera& eye = world.cameras.front();
  const World moving = withMotion(world, eye, 100);
  ASSERT_EQ(moving.events.size(), 99u);
  std::set<int> columns;
  for (std::size_t i = 0; i < moving.events.size(); ++i) {
    const auto* moved = std::get_if<MoveCamera>(&moving.events[i].action);
    ASSERT_NE(moved, nullptr) << i;
    EXPECT_EQ(moving.events[i].frame, int(i) + 1);
    EXPECT_EQ(moved->camera.yaw, eye.yaw);
    EXPECT_LE(glm::distance(moved->camera.position, eye.position), 0.51);
    columns.insert(int(std::floor(moved->camera.position.x + 0.5)));
    if (i == 0) continue;
    const auto& before = std::get<MoveCamera>(moving.events[i - 1].action).camera;
    EXPECT_NEAR(glm::distance(moved->camera.position, before.position), 4.3 / 60, 1e-3) << i;
  }
  EXPECT_GT(columns.size(), 1u);  // over edges of blocks
}

TEST(SceneChanges, a_block_below_the_eye_comes_and_goes_in_every_frame) {
  const World world = smallWorld();
  const World edited = withEdits(world, world.cameras.front(), 6);
  ASSERT_EQ(edited.events.size(), 5u);
  for (std::size_t i = 0; i < edited.events.size(); ++i) {
    const auto* set = std::get_if<SetBlock>(&edited.events[i].action);
    ASSERT_NE(set, nullptr) << i;
    EXPECT_EQ(set->at, glm::ivec3(2, 1, 2));
    EXPECT_EQ(set->state.name, i % 2 == 0 ? "minecraft:stone" : "minecraft:air");
  }
}

TEST(SceneChanges, a_lamp_appears_above_the_eye_once) {
  const World world = smallWorld();
  const World lit = withLamp(world, world.cameras.front(), 7);
  ASSERT_EQ(lit.events.size(), 1u);
  EXPECT_EQ(lit.events[0].frame, 7);
  EXPECT_EQ(std::get<SetBlock>(lit.events[0].action).at, glm::ivec3(2, 3, 2));
  EXPECT_TRUE(withoutEvents(world).events.empty());
}

}  // namespace
}  // namespace orris
