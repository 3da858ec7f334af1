// The propagation against its closed-form and lattice numbers.
#include <gtest/gtest.h>

#include <cmath>

#include "pack_session.h"

namespace orris::test {
namespace {

// One lamp in the air; the eye is ten blocks south of it, at night.
const char* const kLampWorld = R"({
  "size": [1, 1, 1],
  "blocks": [{"box": "glowstone", "min": [0, 0, 0], "max": [0, 0, 0]}],
  "cameras": [{"name": "eye", "position": [0.5, 0.5, 10.5], "yaw": 180}],
  "environment": {"time": 18000}
})";
const glm::ivec3 kLamp = cellOf({0, 0, 0}, {0, 0, 10});

TEST(floodfill, one_step_lights_exactly_the_six_neighbours) {
  PackSession pack(kLampWorld, {{"FLOODFILL_INTERVAL", "1"}});
  pack.renderFrames(1);
  const CellField light = pack.light();
  EXPECT_EQ(light.countLit(), 7);  // and the lamp
  const float first = light.red(kLamp + glm::ivec3(1, 0, 0));
  EXPECT_NEAR(first / light.red(kLamp), 2.43902 / 6, 2e-4);
  for (const glm::ivec3 offset : {glm::ivec3(-1, 0, 0), glm::ivec3(0, 1, 0), glm::ivec3(0, -1, 0),
                                  glm::ivec3(0, 0, 1), glm::ivec3(0, 0, -1)})
    EXPECT_EQ(light.red(kLamp + offset), first);
}

TEST(floodfill, front_advances_one_cell_a_step) {
  PackSession pack(kLampWorld, {{"FLOODFILL_INTERVAL", "1"}});
  for (int step = 1; step <= 6; ++step) {
    pack.renderFrames(1);
    const CellField light = pack.light();
    EXPECT_GT(light.red(kLamp + glm::ivec3(step, 0, 0)), 0) << step;
    EXPECT_EQ(light.red(kLamp + glm::ivec3(step + 1, 0, 0)), 0) << step;
  }
}

TEST(floodfill, frames_between_steps_change_nothing) {
  PackSession pack(kLampWorld, {});
  std::vector<int> changes;  // frames whose light differs from the frame before
  pack.renderFrames(1);
  for (CellField before = pack.light(); changes.size() < 3;) {
    pack.renderFrames(1);
    CellField now = pack.light();
    if (!(now == before)) changes.push_back(pack.session().frame());
    before = std::move(now);
    ASSERT_LE(pack.session().frame(), 12);
  }
  EXPECT_EQ(changes[1] - changes[0], 3);
  EXPECT_EQ(changes[2] - changes[1], 3);
}

TEST(floodfill, steady_light_falls_off_as_the_lattice_predicts) {
  PackSession pack(kLampWorld, {{"FLOODFILL_INTERVAL", "1"}});
  pack.renderFrames(70);
  const CellField light = pack.light();
  const std::pair<int, double> expected[] = {{1, .4557},  {2, .2199},  {3, .1118},   {4, .05937},
                                             {6, .01826}, {8, .00601}, {12, 7.13e-4}};
  for (const auto& [distance, share] : expected)
    EXPECT_NEAR(light.red(kLamp + glm::ivec3(distance, 0, 0)) / light.red(kLamp) / share, 1, .005)
        << distance;
}

TEST(floodfill, removed_lamp_fades_in_the_predicted_steps) {
  const char* const world = R"({
    "size": [1, 1, 1],
    "blocks": [{"box": "glowstone", "min": [0, 0, 0], "max": [0, 0, 0]}],
    "cameras": [{"name": "eye", "position": [0.5, 0.5, 10.5], "yaw": 180}],
    "environment": {"time": 18000},
    "events": [{"frame": 60, "set": {"at": [0, 0, 0], "block": "air"}}]
  })";
  PackSession pack(world, {{"FLOODFILL_INTERVAL", "1"}});
  pack.renderFrames(60);
  const float lamp = pack.light().red(kLamp);
  const auto steps = [&pack, lamp](double share) {
    for (int step = 1; step <= 60; ++step) {
      pack.renderFrames(1);
      if (pack.light().brightest() < share * lamp) return step;
    }
    return 0;
  };
  const int onePercent = steps(0.01);
  EXPECT_NEAR(onePercent, 29, 1);
  EXPECT_NEAR(onePercent + steps(0.001), 52, 1);
}

TEST(floodfill, two_lamps_add_in_the_power_not_in_light) {
  const char* const world = R"({
    "size": [5, 1, 1],
    "blocks": [{"box": "glowstone", "min": [0, 0, 0], "max": [0, 0, 0]},
               {"box": "glowstone", "min": [4, 0, 0], "max": [4, 0, 0]}],
    "cameras": [{"name": "eye", "position": [2.5, 0.5, 10.5], "yaw": 180}],
    "environment": {"time": 18000}
  })";
  PackSession one(kLampWorld, {{"FLOODFILL_INTERVAL", "1"}});
  PackSession two(world, {{"FLOODFILL_INTERVAL", "1"}});
  one.renderFrames(40);
  two.renderFrames(40);
  const float single = one.light().red(kLamp + glm::ivec3(2, 0, 0));
  const float both = two.light().red(cellOf({2, 0, 0}, {2, 0, 10}));
  EXPECT_NEAR(both / single, 1.370, .005);
}

TEST(floodfill, closed_wall_lets_nothing_through) {
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

TEST(floodfill, lamp_at_an_edge_of_the_volume_lights_no_other_tile) {
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
