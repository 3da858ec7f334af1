// The sky that the published method adds, the rule that conserves light, and how light is looked up.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "lab.h"
#include "linear_field.h"

namespace orris::test {
namespace {

const OptionValues kPublishedSky = {{"FLOODFILL_SKY", "PUBLISHED"}};

/// Steady light under an open sky of 1, in red.
float underTheSky(OptionValues constants) {
  constants.emplace("SKY_STRENGTH", kSkyOfOne);
  Lab lab({.initial = "vec3(10.0)",
           .periodic = true,
           .options = kPublishedSky,
           .constants = constants});
  lab.step(120);
  return lab.light().red({16, 16, 16});
}

// Row A8 of docs/failure-modes.md.
TEST(FloodfillSky, open_sky_is_counted_eleven_times) {
  const double gain = Rule{}.gain(6);
  EXPECT_NEAR(gain / (1 - gain), 11.17, .01);
  EXPECT_NEAR(underTheSky({}) / 11.17, 1, .01);
}

TEST(FloodfillSky, little_of_alpha_is_much_of_sky_light) {
  EXPECT_NEAR(underTheSky({{"FLOODFILL_ALPHA", "2.4634"}}) / 12.70, 1, .015);
  EXPECT_NEAR(underTheSky({{"FLOODFILL_ALPHA", "2.2"}}) / 4.81, 1, .01);
}

// Where the steps of a half float are largest, just above a power of two: light that grows stalls when
// what a step adds is less than half of one, twice as early if half floats are cut off.
TEST(FloodfillSky, light_stalls_half_a_step_of_storage_early) {
  Lab lab({.initial = "vec3(0.5)",
           .periodic = true,
           .options = kPublishedSky,
           .constants = {{"SKY_STRENGTH", "47.0"}}});  // 0.094 in red
  lab.step(150);
  const double gain = Rule{}.gain(6), steady = .094 * gain / (1 - gain);
  const double stall = std::pow(2, -11) / (1 - gain);
  EXPECT_NEAR(lab.light().red({16, 16, 16}), steady - stall, stall / 4);
}

TEST(FloodfillSky, too_bright_a_sky_saturates) {
  Lab lab({.periodic = true,
           .options = kPublishedSky,
           .constants = {{"SKY_STRENGTH", "3000000.0"}},  // 6000 in red
           .change = storeFullFloats});
  lab.step(60);
  EXPECT_EQ(lab.light().red({16, 16, 16}), 65504.0f);
}

TEST(FloodfillSky, roof_keeps_the_sky_out) {
  Lab lab({.blocks = R"({"box": "stone", "min": [0, 24, 0], "max": [31, 24, 31]})",
           .options = kPublishedSky,
           .constants = {{"SKY_STRENGTH", kSkyOfOne}}});
  lab.step(1);
  const CellField light = lab.light();
  EXPECT_GT(light.red({16, 25, 16}), .8);
  EXPECT_EQ(light.red({16, 23, 16}), 0);
  EXPECT_EQ(light.red({16, 12, 16}), 0);
}

const OptionValues kConserving = {{"FLOODFILL_RULE", "CONSERVING"}};

/// Walls of every block reflect `albedo` and send out their lamp's light besides.
std::function<void(PackTexts&)> reflecting(const std::string& albedo) {
  return [albedo](PackTexts& files) {
    std::string& rule = files["/include/floodfill/propagation.glsl"];
    edit(rule, "return lamp_radiance(v);", "return lamp_radiance(v) + own * " + albedo + ";");
    edit(rule, "return v.color * own;", "return own * " + albedo + ";");
  };
}

LabSetup conservingRoom(const std::string& wall, int n, const std::string& albedo) {
  return {.blocks = fmt::format(R"({{"hollow": "{0}", "min": [7, 7, 7], "max": [{1}, {1}, {1}]}})",
                                wall, 8 + n),
          .options = kConserving,
          .constants = {{"EMISSION_STRENGTH", "1.0"}},
          .change = reflecting(albedo)};
}

// Row A19 of docs/failure-modes.md.
TEST(FloodfillConserving, open_air_loses_no_light) {
  Lab lab({.initial = "vec3(1.0)", .periodic = true, .options = kConserving});
  lab.step(60);
  EXPECT_EQ(lab.light().red({16, 16, 16}), 1.0f);
}

TEST(FloodfillConserving, gain_of_a_room_that_absorbs) {
  for (const int n : {4, 8, 16}) {
    LabSetup setup = conservingRoom("stone", n, "0.0");
    std::string shape = "1.0";
    for (const char axis : {'x', 'y', 'z'})
      shape += fmt::format(" * sin({} * float(cell.{} - 7))", std::numbers::pi / (n + 1), axis);
    setup.initial = "vec3(" + shape + ")";
    Lab lab(setup);
    const glm::ivec3 middle(8 + n / 2);
    lab.step(1);
    const double first = lab.light().red(middle);
    lab.step(20);
    EXPECT_NEAR(std::pow(lab.light().red(middle) / first, 1 / 20.),
                std::cos(std::numbers::pi / (n + 1)), 1e-4)
        << n;
  }
}

// The exact value in a room whose walls send out E and reflect rho is E / (1 - rho) everywhere.
TEST(FloodfillConserving, furnace_reaches_emission_over_absorption_in_the_predicted_steps) {
  Lab lab(conservingRoom("glowstone", 16, "0.5"));
  lab.step(381 - 4);
  EXPECT_LT(lab.light().red(glm::ivec3(16)), .99f * 2);
  lab.step(8);
  EXPECT_GT(lab.light().red(glm::ivec3(16)), .99f * 2);
}

TEST(FloodfillConserving, furnace_stays_at_emission_over_absorption) {
  LabSetup setup = conservingRoom("glowstone", 6, "0.8");
  setup.initial = "vec3(5.0)";
  Lab lab(setup);
  lab.step(100);
  EXPECT_NEAR(lab.light().red(glm::ivec3(11)), 5, 1e-3);
}

/// Mean of many looked-up values over the face +x of block (9, 10, 16): the field is 1 in front of a
/// wall and above a floor, and the face touches the floor.
double meanLookup(const std::string& lookup) {
  const std::string program = R"(#version 330 compatibility
#include "/settings.glsl"
#define HAS_VOXEL_READS
#include "/include/floodfill/light_field.glsl"
#include "/include/math/random.glsl"
/*
const int colortex7Format = RGBA32F;
*/
/* RENDERTARGETS: 7 */
layout(location = 0) out vec4 result;
void main() {
    seed_random(ivec2(gl_FragCoord.xy), frameCounter);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < 32; ++i) {
        vec3 position = vec3(10.0, 10.0, 16.0) + vec3(0.0, next_random().xy);
        sum += light_at_face(position, vec3(1.0, 0.0, 0.0), next_random().xy);
    }
    result = vec4(sum / 32.0, 1.0);
}
)";
  Lab lab({.blocks = R"({"box": "stone", "min": [0, 0, 0], "max": [9, 31, 31]},
                        {"box": "stone", "min": [10, 0, 0], "max": [31, 9, 31]})",
           .initial = "vec3(cell.x > 9 && cell.y > 9 ? 1.0 : 0.0)",
           .initialStep = 1,
           .width = 64,
           .options = {{"FLOODFILL_LOOKUP", lookup}, {"FLOODFILL_INTERVAL", "6"}},
           .change = [program](PackTexts& files) {
             files["/composite1.fsh"] = program;
             files["/composite1.vsh"] = kFullscreen;
           }});
  lab.step(2);
  const ImageF values = lab.pack().dump("colortex7");
  double sum = 0;
  for (size_t i = 0; i < values.pixels.size(); i += values.channels) sum += values.pixels[i];
  return sum / (values.width * values.height);
}

// Row A18 of docs/failure-modes.md.
TEST(FloodfillWalls, published_lookup_reads_an_eighth_of_its_samples_from_the_floor) {
  EXPECT_NEAR(meanLookup("PUBLISHED"), .875, .005);
}

TEST(FloodfillWalls, lookup_between_open_cells_reads_no_wall) {
  EXPECT_NEAR(meanLookup("SOLID_AWARE"), 1, .005);
}

}  // namespace
}  // namespace orris::test
