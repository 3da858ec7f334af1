// FLOODFILL_STORAGE=IMAGE_3D against the atlas, and that it leaves alone what rests.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "lab.h"
#include "linear_field.h"

namespace orris::test {
namespace {

Lab labOf(LabSetup setup, const char* storage) {
  setup.options["FLOODFILL_STORAGE"] = storage;
  return Lab(setup);
}

/// Cells whose light differs by more than `share` of it and `least`.
int countDifferent(const CellField& one, const CellField& other, double share, double least) {
  int different = 0;
  forEachCell(kLabSize, [&](glm::ivec3 cell) {
    for (int i = 0; i < 3; ++i) {
      const double a = one.at(cell)[i], b = other.at(cell)[i];
      different += !(std::abs(a - b) <= share * std::max(a, b) + least);
    }
  });
  return different;
}

// Walls, lamps, coloured glass, slabs; edits; and an eye that moves between the steps.
LabSetup everything(const char* rule, const char* sky) {
  return {
      .blocks = R"({"hollow": "red_concrete", "min": [6, 6, 6], "max": [26, 20, 26]},
                       {"block": "glowstone", "at": [[9, 18, 9], [20, 10, 22]]},
                       {"box": "blue_stained_glass", "min": [15, 7, 7], "max": [15, 19, 25]},
                       {"block": "stone_slab", "at": [[12, 10, 12], [21, 10, 22]]},
                       {"box": "stone_slab", "min": [17, 14, 17], "max": [23, 14, 25]},
                       {"box": "stone_slab[type=top]", "min": [17, 8, 17], "max": [23, 8, 25]},
                       {"block": "redstone_torch", "at": [12, 11, 12]})",
      .events = R"({"frame": 7, "set": {"at": [9, 18, 9], "block": "air"}},
                       {"frame": 13, "set": {"at": [16, 11, 20], "block": "sea_lantern"}},
                       {"frame": 15, "set": {"at": [24, 10, 22], "block": "stone"}})",
      .options = {{"FLOODFILL_RULE", rule}, {"FLOODFILL_SKY", sky}, {"FLOODFILL_INTERVAL", "2"}}};
}

void expectTheAtlas(const char* rule, const char* sky, double share, double least) {
  Lab atlas = labOf(everything(rule, sky), "ATLAS_2D");
  Lab image = labOf(everything(rule, sky), "IMAGE_3D");
  Camera eye = atlas.pack().session().camera();
  for (int frame = 0; frame < 36; ++frame) {
    if (frame > 20) eye.position += glm::dvec3(0.6, -0.4, 0.3);
    for (Lab* one : {&atlas, &image}) {
      one->pack().session().setCamera(eye);
      one->step();
    }
    ASSERT_EQ(countDifferent(atlas.light(), image.light(), share, least), 0)
        << rule << " frame " << frame;
  }
  EXPECT_GT(image.light().countLit(), 3000) << rule;
}

TEST(FloodfillImage, holds_the_light_of_the_atlas) { expectTheAtlas("PUBLISHED", "NONE", 1e-2, 3e-4); }

TEST(FloodfillImage, holds_the_light_of_the_atlas_under_the_sky) {
  expectTheAtlas("PUBLISHED", "PUBLISHED", 1e-2, 3e-4);
}

TEST(FloodfillImage, holds_the_same_bits_where_the_rule_conserves) {
  expectTheAtlas("CONSERVING", "PUBLISHED", 0, 0);
}

// Changes of the power below a 1024th and of light below 1e-4 are left out.
TEST(FloodfillImage, falls_off_as_theory_predicts) {
  Lab image = labOf({.blocks = kLampBlock}, "IMAGE_3D");
  image.step(70);
  LinearField field(kLabSize);
  field.setLamp({16, 16, 16}, image.light().red({16, 16, 16}));
  field.step(70);
  const CellField light = image.light();
  for (int r = 1; r <= 12; ++r) {
    const glm::ivec3 cell(16 + r, 16, 16);
    EXPECT_NEAR(light.red(cell) / field.at(cell), 1, 7e-3) << r;
  }
}

/// Light of a lamp after 70 steps of `options`, one cell beside it holding `value` before the tenth.
CellField lightAfter(const char* value, const OptionValues& options) {
  const auto poke = [&](PackTexts& files) {
    edit(
        files["/program/floodfill/image_step.glsl"], "    uint listed = ",
        fmt::format("    if (frameCounter == 10) imageStore(flood_light, flood_texel(ivec3(18, 16, "
                    "16), step_stamp() - 1u), {});\n    uint listed = ",
                    value));
  };
  LabSetup setup = {.blocks = kLampBlock, .options = options};
  if (value != nullptr) setup.change = poke;
  Lab lab = labOf(setup, "IMAGE_3D");
  lab.step(70);
  return lab.light();
}

TEST(FloodfillImage, bad_value_is_gone_after_a_step) {
  const OptionValues conserving = {{"FLOODFILL_RULE", "CONSERVING"}};
  const CellField clean = lightAfter(nullptr, conserving);
  for (const char* value :
       {"vec4(uintBitsToFloat(0x7fc00000u))", "vec4(uintBitsToFloat(0x7f800000u))", "vec4(-1.0)"})
    EXPECT_EQ(countDifferent(clean, lightAfter(value, conserving), 1e-2, 3e-4), 0) << value;
}

// Codes have no bad values. Summing light itself doubles it in open air with every step.
TEST(FloodfillImage, growth_ends_at_the_largest_light) {
  Lab lab = labOf({.blocks = kLampBlock,
                   .options = {{"FLOODFILL_GAMMA", "1.0"}},
                   .constants = {{"EMISSION_STRENGTH", "4000.0"}}},
                  "IMAGE_3D");
  lab.step(20);
  const CellField light = lab.light();
  EXPECT_EQ(light.brightest(), 65504);
  EXPECT_GT(light.countLit(), 10000);
}

/// Bricks that the last frame's step reckoned.
int activeBricks(Lab& lab) { return static_cast<int>(*lab.pack().dump("flood_list").at(0, 2)); }

TEST(FloodfillImage, rests_when_settled_and_wakes_for_edits) {
  const LabSetup setup = {
      .blocks = R"({"block": "glowstone", "at": [12, 13, 12]})",
      .events = R"({"frame": 150, "set": {"at": [18, 12, 18], "block": "sea_lantern"}})"};
  Lab image = labOf(setup, "IMAGE_3D"), atlas = labOf(setup, "ATLAS_2D");
  image.step(1);
  EXPECT_EQ(activeBricks(image), 64) << "all of them in the first step";
  image.step(1);
  EXPECT_EQ(activeBricks(image), 7) << "the lamp's and the six beside it";
  image.step(98);
  EXPECT_EQ(activeBricks(image), 0);
  image.step(51);
  EXPECT_EQ(activeBricks(image), 7) << "about the new lamp";
  image.step(99);
  EXPECT_EQ(activeBricks(image), 0);
  atlas.step(250);
  EXPECT_EQ(countDifferent(atlas.light(), image.light(), 1e-2, 3e-4), 0);
}

/// A shaft one block wide with a lamp in its ground, and what else is in it.
std::string shaft(const std::string& inside) {
  return R"({"box": "stone", "min": [12, 0, 12], "max": [20, 20, 20]},
            {"block": "sea_lantern", "at": [16, 2, 16]},
            {"box": ")" +
         inside + R"(", "min": [16, 3, 16], "max": [16, 20, 16]})";
}

/// Both storages through `events` at frame 30 and 70, each time until the light has followed.
void expectTheAtlasAfterEvents(const LabSetup& setup) {
  Lab atlas = labOf(setup, "ATLAS_2D"), image = labOf(setup, "IMAGE_3D");
  for (const int frames : {65, 40}) {
    for (Lab* one : {&atlas, &image}) one->step(frames);
    EXPECT_GT(atlas.light().countLit(), 5);
    EXPECT_EQ(countDifferent(atlas.light(), image.light(), 1e-2, 3e-4), 0) << frames;
  }
}

// Cells keep their place, so that beyond each end of the volume lies what is at the other.
TEST(FloodfillImage, light_ends_where_the_volume_ends) {
  const LabSetup setup = {.blocks = R"({"block": "glowstone", "at": [[0, 0, 0], [31, 31, 31]]})"};
  Lab atlas = labOf(setup, "ATLAS_2D"), image = labOf(setup, "IMAGE_3D");
  for (Lab* one : {&atlas, &image}) one->step(12);
  EXPECT_EQ(countDifferent(atlas.light(), image.light(), 1e-2, 3e-4), 0);
}

// The cell above the slab is in another brick of 8^3, in which no block changed.
TEST(FloodfillImage, slab_closes_the_cell_of_the_brick_above) {
  expectTheAtlasAfterEvents(
      {.blocks = shaft("air"),
       .events = R"({"frame": 30, "set": {"at": [16, 7, 16], "block": "stone_slab[type=top]"}},
                    {"frame": 70, "set": {"at": [16, 7, 16], "block": "air"}})"});
}

std::string stoneInFrame5(int x, int y, int z) {
  return fmt::format(R"({{"frame": 5, "set": {{"at": [{}, {}, {}], "block": "stone"}}}})", x, y, z);
}

// Water is known by its surface: no face tells that it is gone from a brick in the middle of a lake. With glass the world
// has something translucent to the end, or all would begin anew.
void expectChangeOfTheWholeLake(const std::string& events) {
  Lab lab({.blocks = R"({"box": "stone", "min": [12, 0, 12], "max": [20, 20, 20]},
                    {"box": "water", "min": [16, 3, 16], "max": [16, 20, 16]},
                    {"block": "red_stained_glass", "at": [28, 4, 28]})",
           .events = events,
           .options = {{"FLOODFILL_STORAGE", "IMAGE_3D"}}});
  lab.step(6);
  const ImageF memory = lab.pack().dump("voxel_memory");
  const auto changed = [&](int x, int y, int z) { return *memory.at((z * 4 + y) * 4 + x, 1) == 6; };
  for (int y = 0; y < 4; ++y) EXPECT_TRUE(changed(2, y, 2)) << y;
  EXPECT_TRUE(changed(0, 0, 0));
  EXPECT_FALSE(changed(3, 1, 3));
}

TEST(FloodfillImage, change_in_a_lake_is_one_of_all_bricks_of_its_column) {
  expectChangeOfTheWholeLake(stoneInFrame5(16, 20, 16) + "," + stoneInFrame5(4, 4, 4));
}

TEST(FloodfillImage, end_of_a_lake_is_a_change_of_all_bricks_of_its_column) {
  std::string events = stoneInFrame5(4, 4, 4);
  for (int y = 3; y <= 20; ++y) events += "," + stoneInFrame5(16, y, 16);
  expectChangeOfTheWholeLake(events);
}

TEST(FloodfillImage, light_at_rest_is_the_same_bits_in_every_frame) {
  Lab image = labOf({.blocks = kLampBlock}, "IMAGE_3D");
  image.step(90);
  const CellField before = image.light();
  for (int i = 0; i < 3; ++i) {
    image.step(1);
    EXPECT_TRUE(image.light() == before) << i;
  }
}

TEST(FloodfillImage, moving_leaves_the_middle_at_rest) {
  Lab image = labOf({.blocks = kLampBlock}, "IMAGE_3D");
  image.step(150);
  Camera eye = image.pack().session().camera();
  eye.position += glm::dvec3(1, 0, -2);
  image.pack().session().setCamera(eye);
  image.step(1);
  EXPECT_EQ(activeBricks(image), 0) << "nothing but air came in";
  EXPECT_GT(image.light().red({15, 16, 18}), 0.9f * image.light().brightest()) << "the lamp";
}

}  // namespace
}  // namespace orris::test
