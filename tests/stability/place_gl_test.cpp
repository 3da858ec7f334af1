// Where light goes within the volume: to six neighbours, never through a wall or over its edge, and
// along with the camera.
#include <gtest/gtest.h>

#include "lab.h"

namespace orris::test {
namespace {

const glm::ivec3 kAway[6] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};

TEST(A13, one_step_lights_exactly_the_six_neighbours) {
  Lab lab({.blocks = R"({"block": "glowstone", "at": [12, 14, 18]})"});
  lab.step();
  const CellField light = lab.light();
  const glm::ivec3 lamp(12, 14, 18);
  EXPECT_EQ(light.countLit(), 7) << "and the lamp";
  const float first = light.red(lamp + kAway[0]);
  EXPECT_NEAR(first / light.red(lamp), 2.43902 / 6, 2e-4);
  for (const glm::ivec3 away : kAway) EXPECT_EQ(light.red(lamp + away), first);
}

TEST(A13, light_of_a_lamp_is_symmetric_to_the_last_bit) {
  Lab lab({.blocks = R"({"block": "glowstone", "at": [16, 16, 16]})"});
  lab.step(9);
  const CellField light = lab.light();
  int different = 0;
  for (int z = 1; z < kLabSize; ++z)
    for (int y = 1; y < kLabSize; ++y)
      for (int x = 1; x < kLabSize; ++x) {
        const float here = light.red({x, y, z});
        different += here != light.red({kLabSize - x, y, z}) ||
                     here != light.red({x, kLabSize - y, z}) ||
                     here != light.red({x, y, kLabSize - z}) || here != light.red({y, z, x});
      }
  EXPECT_EQ(different, 0);
}

TEST(A14, frames_between_steps_are_bit_identical) {
  Lab lab({.blocks =
               R"({"block": "glowstone", "at": [12, 14, 18]}, {"block": "stone", "at": [0, 0, 0]})",
           .events = R"({"frame": 12, "set": {"at": [12, 14, 18], "block": "air"}})",
           .options = {{"FLOODFILL_INTERVAL", "3"}}});
  CellField before = lab.light();
  for (int frame = 0; frame < 24; ++frame) {
    lab.step();
    CellField now = lab.light();
    EXPECT_EQ(now == before, frame % 3 != 0) << "frame " << frame;
    before = std::move(now);
  }
}

TEST(A18, closed_wall_lets_nothing_through) {
  const char* const world = R"({
    "size": [5, 5, 5],
    "blocks": [{"hollow": "stone", "min": [0, 0, 0], "max": [4, 4, 4]},
               {"box": "glowstone", "min": [2, 2, 2], "max": [2, 2, 2]}],
    "cameras": [{"name": "eye", "position": [2.5, 2.5, 10.5], "yaw": 180}],
    "environment": {"time": 18000}
  })";
  PackSession pack(world, {{"FLOODFILL_INTERVAL", "1"}});
  pack.renderFrames(20);
  const CellField light = pack.light();
  EXPECT_EQ(light.countLit(), 27);  // the inside
  EXPECT_EQ(light.red(cellOf({2, 2, 5}, {2, 2, 10})), 0);
}

TEST(A16, lamp_at_an_edge_of_the_volume_lights_no_other_tile) {
  const char* const world = R"({
    "size": [1, 1, 1],
    "blocks": [{"box": "glowstone", "min": [0, 0, 0], "max": [0, 0, 0]}],
    "cameras": [{"name": "eye", "position": [-30.5, 0.5, -30.5], "yaw": 0, "pitch": 0}],
    "environment": {"time": 18000}
  })";
  PackSession pack(world, {{"FLOODFILL_INTERVAL", "1"}});
  pack.renderFrames(12);
  const CellField light = pack.light();
  ASSERT_GT(light.red({63, 32, 63}), 0) << "the lamp is in the last row and column of its tile";
  EXPECT_EQ(light.red({0, 33, 63}), 0) << "next tile in the row";
  EXPECT_EQ(light.red({63, 48, 0}), 0) << "next tile in the column";
  int lit = 0;  // what the front reaches in 12 steps
  for (int y = 20; y < 45; ++y)
    for (int z = 48; z < 64; ++z)
      for (int x = 48; x < 64; ++x) lit += light.red({x, y, z}) > 0;
  EXPECT_EQ(light.countLit(), lit);
}

}  // namespace
}  // namespace orris::test
