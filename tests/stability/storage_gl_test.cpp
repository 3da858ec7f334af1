// What half floats and divergence do to the light, and that a bad value stays where it is.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "lab.h"
#include "linear_field.h"

namespace orris::test {
namespace {

constexpr float kLargest = 65504;  // half float
/// Values that no light may have.
int countBad(const CellField& light) {
  int bad = 0;
  forEachCell(light.volume(), [&](glm::ivec3 cell) {
    const auto texel = light.at(cell);
    for (int i = 0; i < 3; ++i) bad += !(texel[i] >= 0 && texel[i] <= kLargest);
  });
  return bad;
}

// Row A9 of docs/failure-modes.md.
// Summing light itself under the published alpha doubles it in open air with every step.
TEST(FloodfillCurve, without_the_power_only_narrow_places_stay_dark) {
  const OptionValues linear = {{"FLOODFILL_GAMMA", "1.0"}};
  const std::tuple<const char*, const char*, double> places[] = {
      {"single cell and 1-wide corridor", "[26, 10, 10]", .813},
      {"2x2x1 pocket", "[11, 11, 10]", .813},
      {"2^3 room", "[11, 11, 11]", 1.220},
      {"2-wide corridor", "[26, 11, 11]", 1.626}};
  for (const auto& [name, high, gain] : places) {
    Lab lab({.blocks = fmt::format(R"({{"box": "stone", "min": [4, 4, 4], "max": [30, 17, 17]}},
                                      {{"box": "air", "min": [10, 10, 10], "max": {}}})",
                                   high),
             .initial = "vec3(1.0)",
             .options = linear});
    lab.step(4);
    const bool along = std::string(high).starts_with("[26");
    const float light = lab.light().red({along ? 18 : 10, 10, 10});
    EXPECT_NEAR(std::pow(light, 0.25), gain, .002) << name;
  }
}

TEST(FloodfillCurve, growth_reaches_the_largest_half_float_when_predicted_and_stays_there) {
  for (const auto& [lamp, step] : {std::pair("400.0", 12), std::pair("4000.0", 9)}) {
    Lab lab({.blocks = kLampBlock,
             .options = {{"FLOODFILL_GAMMA", "1.0"}},
             .constants = {{"EMISSION_STRENGTH", lamp}},
             .change = storeFullFloats});
    int reached = 0;
    for (int i = 1; i <= 50; ++i) {
      lab.step();
      const CellField light = lab.light();
      ASSERT_EQ(countBad(light), 0) << lamp << " step " << i;
      if (reached == 0 && light.brightest() == kLargest) reached = i;
    }
    EXPECT_NEAR(reached, step, 1) << lamp;
  }
}

// Row A10 of docs/failure-modes.md.
TEST(FloodfillCurve, uniform_light_fades_to_a_thousandth_within_100_steps) {
  Lab lab({.initial = "vec3(1.0)", .periodic = true});
  lab.step(100);
  EXPECT_LT(lab.light().red({16, 16, 16}), 1e-3);
}

// Row A11 of docs/failure-modes.md.
TEST(FloodfillStorage, no_glow_is_left_after_400_steps) {
  Lab lab({.initial = "vec3(1.0)", .periodic = true});
  lab.step(400);
  EXPECT_LE(lab.light().brightest(), 1e-6);
}

// GLSL of what no light may be.
const char* const kBadValues[] = {"uintBitsToFloat(0x7fc00000u)", "uintBitsToFloat(0x7f800000u)",
                                  "-1.0"};

// A lamp, so that there is light to spoil, and a wall: infinity times no visibility is no number.
LabSetup poked(const std::string& value) {
  return {.blocks = std::string(kLampBlock) +
                    R"(, {"box": "stone", "min": [20, 14, 14], "max": [20, 18, 18]})",
          .initial = fmt::format("(cell == ivec3(18, 16, 16) || cell == ivec3(20, 16, 16)) "
                                 "? vec3({}) : light.rgb",
                                 value),
          .initialStep = 10};
}

// Row A12 of docs/failure-modes.md.
TEST(FloodfillStorage, bad_value_is_taken_for_darkness_to_the_last_bit) {
  for (const char* value : kBadValues) {
    Lab lab(poked(value)), dark(poked("0.0"));
    lab.step(10);
    dark.step(10);
    for (int step = 1; step <= 5; ++step) {
      lab.step();
      dark.step();
      const CellField light = lab.light();
      EXPECT_EQ(countBad(light), 0) << value << " step " << step;
      EXPECT_TRUE(light == dark.light()) << value << " step " << step;
    }
  }
}

TEST(FloodfillStorage, bad_value_is_forgotten_after_sixty_steps) {
  Lab clean(poked("light.rgb"));
  clean.step(70);
  const CellField expected = clean.light();
  for (const char* value : kBadValues) {
    Lab lab(poked(value));
    lab.step(70);
    const CellField after = lab.light();
    int different = 0;
    forEachCell(kLabSize, [&](glm::ivec3 cell) {
      // Half floats below 6e-5 have fewer digits.
      const double allowed = 1e-3 * expected.red(cell) + 2e-6;
      different += !(std::abs(after.red(cell) - expected.red(cell)) <= allowed);
    });
    EXPECT_EQ(different, 0) << value;
  }
}

}  // namespace
}  // namespace orris::test
