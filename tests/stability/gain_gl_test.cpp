// What a step multiplies the light by: against the linear recursion and its closed forms.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "lab.h"
#include "linear_field.h"

namespace orris::test {
namespace {

/// The same numbers in GLSL and here: a hash of the cell, 0..255.
constexpr const char* kHashed =
    "vec3(0.1 + float((cell.x * 73 + cell.y * 151 + cell.z * 199 + cell.x * cell.z * 31) & 255) "
    "/ 255.0)";
double hashed(glm::ivec3 c) {
  return 0.1 + ((c.x * 73 + c.y * 151 + c.z * 199 + c.x * c.z * 31) & 255) / 255.0;
}

// Row A0 of docs/failure-modes.md.
TEST(FloodfillGain, is_linear_in_the_power_of_the_light) {
  LinearField theory(kLabSize);
  for (int y = 9; y <= 20; ++y)
    for (int z = 5; z <= 25; ++z) theory.setSolid({12, y, z});
  theory.setLamp({20, 16, 10}, 16);
  theory.fill(hashed);
  Lab lab({.blocks = R"({"box": "stone", "min": [12, 9, 5], "max": [12, 20, 25]},
                        {"block": "glowstone", "at": [20, 16, 10]})",
           .initial = kHashed});
  for (int step = 1; step <= 10; ++step) {
    lab.step();
    theory.step();
    const CellField light = lab.light();
    double worst = 0;
    forEachCell(kLabSize, [&](glm::ivec3 cell) {
      const double expected = theory.at(cell);
      if (expected == 0)
        EXPECT_EQ(light.red(cell), 0) << "in a wall";
      else
        worst = std::max(worst, std::abs(light.red(cell) / expected - 1));
    });
    EXPECT_LT(worst, 1.5e-3) << "step " << step;
  }
}

// Row A1 of docs/failure-modes.md.
// The field is uniform, its rim has fewer open neighbours, and a dead end has one.
TEST(FloodfillGain, gain_of_a_step_follows_the_open_neighbours) {
  Lab lab({.blocks = R"({"box": "stone", "min": [4, 4, 4], "max": [12, 8, 8]},
                        {"box": "air", "min": [5, 6, 6], "max": [11, 6, 6]})",
           .initial = "vec3(1.0)"});
  lab.step();
  const CellField light = lab.light();
  const std::pair<glm::ivec3, int> cells[] = {{{20, 20, 20}, 6}, {{0, 20, 20}, 5}, {{20, 31, 0}, 4},
                                              {{31, 31, 31}, 3}, {{8, 6, 6}, 2},   {{5, 6, 6}, 1}};
  const double known[] = {.407, .557, .670, .763, .845, .91784};
  for (const auto& [cell, open] : cells) {
    EXPECT_NEAR(Rule{}.gain(open), known[open - 1], 5e-4);
    EXPECT_NEAR(light.red(cell) / Rule{}.gain(open), 1, 1e-3) << open;
  }
}

TEST(FloodfillGain, light_grows_beyond_the_limit_of_alpha_only) {
  const Rule rules[] = {{2.55, 2.2},  {2.65, 2.2}, {2.67, 2.2}, {2.75, 2.2},
                        {0.99, 1},    {1.01, 1},   {2.21, 1.8}, {2.23, 1.8},
                        {2.43902, 2}, {2.46, 2},   {2.83, 2.4}, {2.86, 2.4}};
  for (const Rule& rule : rules) {
    Lab lab({.initial = "vec3(1.0)",
             .constants = {{"FLOODFILL_ALPHA", fmt::format("{}", rule.alpha)},
                           {"FLOODFILL_GAMMA", fmt::format("{:.1f}", rule.gamma)}}});
    lab.step(5);
    const double gain = std::pow(lab.light().red({16, 16, 16}), 0.2);
    EXPECT_NEAR(gain / rule.gain(6), 1, 1e-3) << rule.alpha << ' ' << rule.gamma;
    EXPECT_EQ(gain > 1, rule.alpha > std::pow(6, 1 - 1 / rule.gamma))
        << rule.alpha << ' ' << rule.gamma;
  }
}

/// Middle of the volume over steps that start with the slowest shape of a place, so that every
/// step's gain is the same.
double measuredGain(const LabSetup& setup, glm::ivec3 cell, int steps) {
  Lab lab(setup);
  lab.step(1);
  const double first = lab.light().red(cell);
  lab.step(steps);
  return std::pow(lab.light().red(cell) / first, 1.0 / steps);
}

/// GLSL: sine over the axes in `axes`, n cells from cell 10 on, as light.
std::string slowestShape(const std::string& axes, int n) {
  std::string product = "1.0";
  for (const char axis : axes)
    product += fmt::format(" * sin({} * float(cell.{} - 9))", std::numbers::pi / (n + 1), axis);
  return fmt::format("vec3(1000.0 * pow(max({}, 1e-6), 1.0 / 2.2))", product);
}

// Row A2 of docs/failure-modes.md.
TEST(FloodfillGain, gain_of_a_room_with_black_walls) {
  const std::pair<int, double> rooms[] = {{2, .670}, {4, .834}, {8, .8923}, {16, .9107}};
  for (const auto& [n, known] : rooms) {
    const LabSetup setup{
        .blocks = fmt::format(R"({{"hollow": "stone", "min": [9, 9, 9], "max": [{0}, {0}, {0}]}})",
                              10 + n),
        .initial = slowestShape("xyz", n)};
    EXPECT_NEAR(Rule{}.roomGain(n), known, 5e-4);
    EXPECT_NEAR(measuredGain(setup, glm::ivec3(10 + n / 2), 20), Rule{}.roomGain(n), 1e-3) << n;
  }
}

TEST(FloodfillGain, gain_of_a_corridor_with_black_walls) {
  const std::pair<int, double> corridors[] = {{1, .5571}, {2, .763}, {3, .832}};
  for (const auto& [n, known] : corridors) {
    const LabSetup setup{.blocks = fmt::format(
                             R"({{"box": "stone", "min": [9, 9, 0], "max": [{0}, {0}, 31]}},
               {{"box": "air", "min": [10, 10, 0], "max": [{1}, {1}, 31]}})",
                             10 + n, 9 + n),
                         .initial = slowestShape("xy", n)};
    EXPECT_NEAR(Rule{}.corridorGain(n), known, 5e-4);
    EXPECT_NEAR(measuredGain(setup, {10, 10, 16}, 10), Rule{}.corridorGain(n), 1e-3) << n;
  }
}

TEST(FloodfillGain, a_dead_end_has_the_light_of_its_neighbour_times_the_gain_of_one) {
  Lab lab({.blocks = R"({"box": "stone", "min": [8, 8, 8], "max": [20, 10, 10]},
                        {"box": "air", "min": [9, 9, 9], "max": [19, 9, 9]},
                        {"block": "glowstone", "at": [16, 9, 9]})"});
  lab.step(40);
  const CellField light = lab.light();
  EXPECT_NEAR(light.red({19, 9, 9}) / light.red({18, 9, 9}) / 0.4065, 1, 2e-3);
}

}  // namespace
}  // namespace orris::test
