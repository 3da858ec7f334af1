// The propagation against its closed-form and lattice numbers.
#include <gtest/gtest.h>

#include <cmath>

#include "lab.h"
#include "linear_field.h"

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

TEST(A4, front_advances_one_cell_a_step) {
  PackSession pack(kLampWorld, {{"FLOODFILL_INTERVAL", "1"}});
  for (int step = 1; step <= 6; ++step) {
    pack.renderFrames(1);
    const CellField light = pack.light();
    EXPECT_GT(light.red(kLamp + glm::ivec3(step, 0, 0)), 0) << step;
    EXPECT_EQ(light.red(kLamp + glm::ivec3(step + 1, 0, 0)), 0) << step;
  }
}

TEST(A5, steady_light_falls_off_as_the_lattice_predicts) {
  PackSession pack(kLampWorld, {{"FLOODFILL_INTERVAL", "1"}});
  pack.renderFrames(70);
  const CellField light = pack.light();
  const std::pair<int, double> expected[] = {{1, .4557},  {2, .2199},  {3, .1118},   {4, .05937},
                                             {6, .01826}, {8, .00601}, {12, 7.13e-4}};
  for (const auto& [distance, share] : expected)
    EXPECT_NEAR(light.red(kLamp + glm::ivec3(distance, 0, 0)) / light.red(kLamp) / share, 1, .005)
        << distance;
}

TEST(A3, removed_lamp_fades_in_the_predicted_steps) {
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

TEST(A6, two_lamps_add_in_the_power_not_in_light) {
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

}  // namespace
}  // namespace orris::test
