// Light of lamps over space and time, against closed forms and the lattice's exact numbers.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "lab.h"
#include "linear_field.h"

namespace orris::test {
namespace {

const glm::ivec3 kLamp(16, 16, 16);
glm::ivec3 east(int distance) { return kLamp + glm::ivec3(distance, 0, 0); }

/// The first step, counted from now, after which `done` holds; 0: not within `most`.
int stepsUntil(Lab& lab, int most, const std::function<bool(const CellField&)>& done) {
  for (int step = 1; step <= most; ++step) {
    lab.step();
    if (done(lab.light())) return step;
  }
  return 0;
}

// Row A3 of docs/failure-modes.md.
TEST(FloodfillDelay, uniform_light_without_a_source_fades_in_the_predicted_steps) {
  Lab lab({.initial = "vec3(1.0)", .periodic = true});
  const auto below = [](double share) {
    return [share](const CellField& light) { return light.red(kLamp) < share; };
  };
  const int onePercent = stepsUntil(lab, 60, below(0.01));
  EXPECT_NEAR(onePercent, 54, 1);
  EXPECT_NEAR(onePercent + stepsUntil(lab, 60, below(0.001)), 81, 1);
}

TEST(FloodfillDelay, corridor_fades_in_the_predicted_steps) {
  Lab lab({.blocks = R"({"box": "stone", "min": [0, 15, 15], "max": [31, 17, 17]},
                        {"box": "air", "min": [0, 16, 16], "max": [31, 16, 16]})",
           .initial = "vec3(1.0)"});
  const auto below = [](double share) {
    return [share](const CellField& light) { return light.red(kLamp) < share; };
  };
  const int onePercent = stepsUntil(lab, 20, below(0.01));
  EXPECT_NEAR(onePercent, 8, 1);
  EXPECT_NEAR(onePercent + stepsUntil(lab, 20, below(0.001)), 12, 1);
}

// The brightest cell falls fastest; what a distant cell had of its own takes longer to go.
TEST(FloodfillDelay, light_of_a_removed_lamp_fades_in_the_predicted_steps) {
  Lab lab({.blocks = fmt::format(R"({}, {{"block": "stone", "at": [0, 0, 0]}})", kLampBlock),
           .events = R"({"frame": 120, "set": {"at": [16, 16, 16], "block": "air"}})"});
  lab.step(120);
  const CellField steady = lab.light();
  const float lamp = steady.red(kLamp);
  std::map<int, int> own;  // steps to 1 % of a cell's own light, by distance
  std::map<double, int> peak;
  for (int step = 1; step <= 80; ++step) {
    lab.step();
    const CellField light = lab.light();
    for (const int distance : {0, 4, 8})
      if (light.red(east(distance)) < 0.01 * steady.red(east(distance)))
        own.emplace(distance, step);
    for (const double share : {0.01, 0.001})
      if (light.brightest() < share * lamp) peak.emplace(share, step);
  }
  EXPECT_NEAR(peak[0.01], 29, 1);
  EXPECT_NEAR(peak[0.001], 52, 1);
  EXPECT_NEAR(own[0], 29, 1);
  EXPECT_NEAR(own[4], 55, 1);
  EXPECT_NEAR(own[8], 75, 1);
}

// Row A4 of docs/failure-modes.md.
TEST(FloodfillDelay, front_advances_one_cell_a_step) {
  Lab lab({.blocks = kLampBlock});
  for (int step = 1; step <= 6; ++step) {
    lab.step();
    const CellField light = lab.light();
    for (int axis = 0; axis < 3; ++axis)
      for (const int sign : {-1, 1}) {
        glm::ivec3 axisStep(0);
        axisStep[axis] = sign;
        EXPECT_GT(light.red(kLamp + step * axisStep), 0) << step << ' ' << axis;
        EXPECT_EQ(light.red(kLamp + (step + 1) * axisStep), 0) << step << ' ' << axis;
      }
  }
}

TEST(FloodfillDelay, light_builds_up_in_the_predicted_steps) {
  LinearField theory(kLabSize);
  theory.setLamp(kLamp, 16);
  theory.step(300);
  Lab lab({.blocks = kLampBlock});
  std::map<int, int> reached;
  for (int step = 1; step <= 60; ++step) {
    lab.step();
    const CellField light = lab.light();
    for (const int distance : {1, 2, 4, 8, 12})
      if (light.red(east(distance)) >= 0.99 * theory.at(east(distance)))
        reached.emplace(distance, step);
  }
  const std::map<int, int> known = {{1, 8}, {2, 15}, {4, 25}, {8, 41}, {12, 55}};
  for (const auto& [distance, steps] : known) EXPECT_NEAR(reached[distance], steps, 1) << distance;
}

// Row A5 of docs/failure-modes.md.
TEST(FloodfillFalloff, steady_light_falls_off_as_the_lattice_predicts) {
  Lab lab({.blocks = kLampBlock});
  lab.step(80);
  const CellField light = lab.light();
  const std::pair<int, double> expected[] = {{1, .4557},  {2, .2199},  {3, .1118},   {4, .05937},
                                             {6, .01826}, {8, .00601}, {12, 7.13e-4}};
  for (const auto& [distance, share] : expected)
    EXPECT_NEAR(light.red(east(distance)) / light.red(kLamp) / share, 1, .005) << distance;
}

TEST(FloodfillFalloff, diagonal_is_darker_than_an_axis_at_equal_distance) {
  Lab lab({.blocks = kLampBlock});
  lab.step(80);
  const CellField light = lab.light();
  // (4, 4, 4) is 6.93 away; light falls off exponentially between 6 and 7.
  const double between = std::pow(light.red(east(7)) / light.red(east(6)), 0.928);
  const double axis = light.red(east(6)) * between;
  EXPECT_NEAR(light.red(kLamp + glm::ivec3(4)) / axis, 1 - .21, .01);
}

TEST(FloodfillFalloff, corridor_falls_off_by_a_constant_factor) {
  Lab lab({.blocks = fmt::format(R"({{"box": "stone", "min": [0, 15, 15], "max": [31, 17, 17]}},
                                    {{"box": "air", "min": [0, 16, 16], "max": [31, 16, 16]}}, {})",
                                 kLampBlock)});
  lab.step(60);
  const CellField light = lab.light();
  for (int distance = 1; distance <= 8; ++distance)
    EXPECT_NEAR(light.red(east(distance)) / light.red(kLamp) / std::pow(.41014, distance), 1, .005)
        << distance;
}

TEST(FloodfillFalloff, sheet_falls_off_between_corridor_and_open_air) {
  Lab lab({.blocks = fmt::format(R"({{"box": "stone", "min": [0, 15, 0], "max": [31, 17, 31]}},
                                    {{"box": "air", "min": [0, 16, 0], "max": [31, 16, 31]}}, {})",
                                 kLampBlock)});
  lab.step(60);
  EXPECT_NEAR(lab.light().red(east(1)) / lab.light().red(kLamp), .4272, .002);
}

// Row A6 of docs/failure-modes.md.
TEST(FloodfillScale, two_lamps_add_in_the_power_not_in_light) {
  const char* const pair = R"({"block": "glowstone", "at": [[14, 16, 16], [18, 16, 16]]})";
  Lab one({.blocks = R"({"block": "glowstone", "at": [14, 16, 16]})"});
  Lab two({.blocks = pair});
  one.step(40);
  two.step(40);
  EXPECT_NEAR(two.light().red(kLamp) / one.light().red(kLamp), 1.370, .005);
}

// Row A7 of docs/failure-modes.md.
// The exact value in a room whose walls all shine alike is their radiance, whatever its size.
TEST(FloodfillScale, room_with_shining_walls_is_darker_the_larger_it_is) {
  const std::pair<int, double> rooms[] = {{1, .918}, {2, .854}, {4, .609}, {8, .258}, {16, .039}};
  for (const auto& [n, share] : rooms) {
    Lab lab({.blocks = fmt::format(
                 R"({{"hollow": "glowstone", "min": [{0}, {0}, {0}], "max": [{1}, {1}, {1}]}})", 5,
                 6 + n)});
    lab.step(80);
    const CellField light = lab.light();
    const float wall = light.red(glm::ivec3(5));
    // n even: the middle lies between cells, which are alike.
    EXPECT_NEAR(light.red(glm::ivec3(6 + n / 2)) / wall / share, 1, .02) << n;
  }
}

// Row A15 of docs/failure-modes.md.
TEST(FloodfillScale, ten_times_the_emission_is_ten_times_the_light) {
  Lab dim({.blocks = kLampBlock, .constants = {{"EMISSION_STRENGTH", "400.0"}}});
  Lab bright({.blocks = kLampBlock, .constants = {{"EMISSION_STRENGTH", "4000.0"}}});
  dim.step(80);
  bright.step(80);
  const CellField low = dim.light(), high = bright.light();
  for (int distance = 0; distance <= 12; ++distance)
    EXPECT_NEAR(high.red(east(distance)) / low.red(east(distance)), 10, .03) << distance;
  const auto range = [](const CellField& light) {
    int cells = 0;
    while (cells < 15 && light.red(east(cells + 1)) >= 1) ++cells;
    return cells;
  };
  EXPECT_EQ(range(low), 9);
  EXPECT_EQ(range(high), 14);
}

}  // namespace
}  // namespace orris::test
