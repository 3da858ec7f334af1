// Global illumination against stored pictures of the path tracer: sun and sky through windows,
// daylight deep in a hall, a lamp round a corner, a cave with lava, stained windows; and BOUNCE_N
// against light that is cut off after as many rays. The pictures are traced once
// (references/make.sh), so that a mistake in what pack and tracer share shows as well.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <orris/chart/measure/reference_picture.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "pack_session.h"

namespace orris::test {
namespace {

struct View {
  const char* name;  ///< of the test
  const char* world;
  std::size_t camera;
  const char* picture;
  const char* method;
  int samples;  ///< of a frame, which costs more than its rays; but light needs frames to spread in a cache
  double mean;  ///< limit of the relative error of the mean, by channel
  double rms;   ///< limit of that of parts of the picture, by channel; holds the frames' noise
};
void PrintTo(const View& view, std::ostream* out) { *out << view.name; }

/// Rays of a pixel over all frames.
constexpr int kRays = 384;

ImageF drawn(const View& view) {
  PackSession pack = PackSession::ofWorld(view.world,
                                          {{"GI_METHOD", view.method},
                                           {"GI_LAMPS", "SAMPLED"},
                                           {"GI_SAMPLES", std::to_string(view.samples)},
                                           {"GI_FILTER", "false"},
                                           {"TEMPORAL_FRAMES", "1024"},
                                           {"AMBIENT_MINIMUM", "0.0"},
                                           {"DIRECT_LIGHT", "NONE"}},
                                          16, 9, view.camera);
  pack.renderFrames(kRays / view.samples);
  return toRgb(pack.dump("colortex0"));
}

/// Relative errors of one channel, over pixels that are no edges.
struct Errors {
  double mean = 0;  ///< with its sign
  double rms = 0;   ///< of the means of kBlocks parts of the picture, in which noise is smaller
};
constexpr int kBlocksAcross = 4, kBlocksDown = 3, kBlocks = kBlocksAcross * kBlocksDown;

/// Which part of the picture a pixel belongs to.
std::size_t blockOf(const ImageF& picture, std::size_t pixel) {
  const int x = int(pixel) % picture.width, y = int(pixel) / picture.width;
  return std::size_t(x * kBlocksAcross / picture.width +
                     kBlocksAcross * (y * kBlocksDown / picture.height));
}

Errors errorsOf(const ImageF& picture, const ReferencePicture& reference, std::size_t channel) {
  double brightness = 0;
  const std::size_t pixels = picture.pixels.size() / 3;
  for (std::size_t i = 0; i < pixels; ++i)
    brightness += reference.mean.pixels[i * 3 + channel] / double(pixels);
  // Against each half, so that the noise of the reference is not in the product.
  std::array<std::array<double, 2>, kBlocks> sums{};
  std::array<double, kBlocks> counts{};
  for (std::size_t i = 0; i < pixels; ++i) {
    if (!reference.edges.empty() && reference.edges[i] != 0) continue;
    const std::size_t value = i * 3 + channel, block = blockOf(picture, i);
    const double scale = reference.mean.pixels[value] + 0.1 * brightness;
    sums[block][0] += (picture.pixels[value] - reference.first.pixels[value]) / scale;
    sums[block][1] += (picture.pixels[value] - reference.second.pixels[value]) / scale;
    ++counts[block];
  }
  double total = 0, sum = 0, squares = 0;
  for (std::size_t block = 0; block < kBlocks; ++block) {
    if (counts[block] == 0) continue;
    total += counts[block];
    sum += (sums[block][0] + sums[block][1]) / 2;
    squares += sums[block][0] * sums[block][1] / counts[block];
  }
  return {sum / total, std::sqrt(std::max(0.0, squares / total))};
}

// A tunnel longer than the volume, whose ends are shut; above it a floor that gets light under its roof from the sides.
TEST(ReferenceCave, cave_below_a_lit_floor_is_dark) {
  PackSession pack(R"({"size": [48, 12, 9],
      "blocks": [{"box": "stone", "min": [0, 0, 0], "max": [47, 6, 8]},
                 {"box": "air", "min": [1, 2, 3], "max": [46, 4, 5]},
                 {"box": "stone", "min": [0, 10, 1], "max": [47, 10, 7]}],
      "cameras": [{"name": "eye", "position": [24.5, 3.5, 4.5]}],
      "environment": {"time": 6000}})",
                   {{"GI_METHOD", "FACE_CACHE"},
                    {"VOXEL_SIZE", "32"},
                    {"AMBIENT_MINIMUM", "0.0"},
                    {"DIRECT_LIGHT", "NONE"}},
                   16, 9);
  pack.renderFrames(20);
  const glm::dvec3 seen = pack.meanRadiance();
  EXPECT_EQ(std::max({seen.r, seen.g, seen.b}), 0);
}

/// What the sun passes, and the share of its light of a channel that orris trace --bounces 0 finds on a floor behind it:
/// mean over a picture of 128x72.
struct Pane {
  const char* name;
  const char* blocks;  ///< of the world, after the floor
  int time;
  double share;
  int channel = 0;
};
void PrintTo(const Pane& pane, std::ostream* out) { *out << pane.name; }

/// Light of the sun on the floor alone.
glm::dvec3 sunOnFloor(const char* blocks, int time, const char* shadows) {
  glm::dvec3 light(0);
  for (const char* direct : {"PHONG", "NONE"}) {
    PackSession pack(
        fmt::format(R"({{"size": [32, 16, 32],
        "blocks": [{{"box": "white_concrete", "min": [0, 0, 0], "max": [31, 0, 31]}}{}],
        "cameras": [{{"name": "eye", "position": [16, 3.5, 16], "target": [16.01, 0, 16], "fov": 100}}],
        "environment": {{"time": {}}}}})",
                    blocks, time),
        {{"GI_METHOD", "BOUNCE_1"}, {"SHADOW_METHOD", shadows}, {"DIRECT_LIGHT", direct}}, 128, 72);
    pack.renderFrames(1);
    light = glm::dvec3(pack.meanRadiance()) - light;
  }
  return -light;
}

class ReferenceGlass : public testing::TestWithParam<Pane> {};

TEST_P(ReferenceGlass, sun_passes_as_in_the_path_tracer) {
  const Pane& pane = GetParam();
  const glm::dvec3 open = sunOnFloor("", pane.time, "NONE");
  ASSERT_GT(open.r, 0);
  for (const char* shadows : {"MAP_PCF", "VOLUME_AUTO"})
    EXPECT_NEAR((sunOnFloor(pane.blocks, pane.time, shadows) / open)[pane.channel], pane.share, .02)
        << shadows;
}

INSTANTIATE_TEST_SUITE_P(
    , ReferenceGlass,
    testing::Values(
        Pane{"glass", R"(, {"box": "glass", "min": [0, 4, 0], "max": [31, 4, 31]})", 9500, .599},
        Pane{"stained", R"(, {"box": "red_stained_glass", "min": [0, 4, 0], "max": [31, 4, 31]})",
             4000, .298},
        Pane{"water", R"(, {"box": "water", "min": [0, 4, 0], "max": [31, 4, 31]})", 6000, .348, 2},
        Pane{
            "panes",
            R"(, {"box": "glass_pane[north=true,south=true]", "min": [12, 1, 0], "max": [12, 14, 31]},
             {"box": "glass_pane[north=true,south=true]", "min": [20, 1, 0], "max": [20, 14, 31]})",
            2500, .514}),
    [](const auto& tested) { return std::string(tested.param.name); });

/// A closed room of stone by night, seven blocks wide and five high from (2, 2, 2) on, with `blocks` in it.
std::string stoneRoom(const char* blocks, const char* camera) {
  return fmt::format(R"({{"size": [11, 9, 11],
      "blocks": [{{"box": "stone", "min": [0, 0, 0], "max": [10, 8, 10]}},
                 {{"box": "air", "min": [2, 2, 2], "max": [8, 6, 8]}}, {}],
      "cameras": [{{"name": "eye", {}}}], "environment": {{"time": 18000}}}})",
                     blocks, camera);
}

const OptionValues kSettling = {
    {"GI_METHOD", "FACE_CACHE"}, {"GI_LAMPS", "SAMPLED"},     {"GI_SAMPLES", "4"},
    {"GI_FILTER", "false"},      {"TEMPORAL_FRAMES", "1024"}, {"AMBIENT_MINIMUM", "0.0"},
    {"DIRECT_LIGHT", "NONE"},    {"FACE_SHARE", "1"},         {"FACE_WINDOW", "256"}};

/// A room, and the mean of its picture of 16x9: orris trace --noise 0.002.
struct Room {
  const char* name;
  const char* wall;
  const char* lamp;  ///< block and place
  glm::dvec3 mean;
};
void PrintTo(const Room& room, std::ostream* out) { *out << room.name; }

class ReferenceRoom : public testing::TestWithParam<Room> {};

// White wool reflects .86: what is there after so many updates is what bright rooms need to come to rest, and the albedo of
// voxels to a thousandth. Lava in the floor lights the sides of its hole first, which light the room.
TEST_P(ReferenceRoom, is_as_bright_as_in_the_path_tracer) {
  const Room& room = GetParam();
  PackSession pack(fmt::format(R"({{"size": [11, 9, 11],
        "blocks": [{{"box": "{}", "min": [0, 0, 0], "max": [10, 8, 10]}},
                   {{"box": "air", "min": [2, 2, 2], "max": [8, 6, 8]}}, {{{}}}],
        "cameras": [{{"name": "eye", "position": [3, 3.5, 3], "target": [8, 4, 8], "fov": 70}}],
        "environment": {{"time": 18000}}}})",
                               room.wall, room.lamp),
                   kSettling, 16, 9);
  pack.renderFrames(160);
  const glm::dvec3 ratio = glm::dvec3(pack.meanRadiance()) / room.mean;
  RecordProperty("ratio", fmt::format("{:.4f} {:.4f} {:.4f}", ratio.r, ratio.g, ratio.b));
  for (int channel = 0; channel < 3; ++channel) EXPECT_NEAR(ratio[channel], 1, .012) << channel;
}

INSTANTIATE_TEST_SUITE_P(, ReferenceRoom,
                         testing::Values(Room{"of_wool",
                                              "white_wool",
                                              R"("block": "glowstone", "at": [6, 7, 4])",
                                              {.40223, .31025, .16693}},
                                         Room{"with_lava_in_the_floor",
                                              "white_concrete",
                                              R"("block": "lava", "at": [6, 1, 4])",
                                              {.20989, .07228, .01255}}),
                         [](const auto& tested) { return std::string(tested.param.name); });

/// A window of red glass in a house of quartz, and green over red in the mean of a picture of 16x9 inside: orris trace
/// --noise 0.004.
struct Window {
  const char* name;
  const char* glass;  ///< min and max
  double green;
};
void PrintTo(const Window& window, std::ostream* out) { *out << window.name; }

class ReferenceWindow : public testing::TestWithParam<Window> {};

// Of green the glass leaves thousandths, so what passes beside it shows: sunlight at the edge of a hole in the roof, and
// what reaches the sides of a hole in the wall before it has passed the glass.
TEST_P(ReferenceWindow, leaves_little_of_another_colour) {
  const Window& window = GetParam();
  PackSession pack(fmt::format(R"({{"size": [24, 12, 17],
        "blocks": [{{"box": "grass_block", "min": [0, 0, 0], "max": [23, 0, 16]}},
                   {{"hollow": "quartz_block", "min": [3, 0, 3], "max": [18, 9, 14]}},
                   {{"box": "red_stained_glass", {}}}],
        "cameras": [{{"name": "eye", "position": [11.5, 4.62, 10.5], "yaw": 270, "pitch": 0}}],
        "environment": {{"time": 4000}}}})",
                               window.glass),
                   kSettling, 16, 9);
  pack.renderFrames(260);
  const glm::dvec3 seen = pack.meanRadiance();
  RecordProperty("green_over_red", fmt::format("{:.5f}", seen.g / seen.r));
  EXPECT_NEAR(seen.g / seen.r / window.green, 1, .06);
}

INSTANTIATE_TEST_SUITE_P(
    , ReferenceWindow,
    testing::Values(Window{"in_the_wall", R"("min": [3, 3, 6], "max": [3, 6, 10])", .03018},
                    Window{"in_the_roof", R"("min": [8, 9, 6], "max": [13, 9, 10])", .01429}),
    [](const auto& tested) { return std::string(tested.param.name); });

// A window of two layers of glass opposite to one that lets the sun in: what the layers reflect to and fro is a sixth of its
// light. orris trace --noise 0.004: .004572 in green.
TEST(ReferenceGlazedRoom, light_between_the_layers_of_glass_is_found) {
  OptionValues options = kSettling;
  options["SKY_STRENGTH"] = "0.0";
  PackSession pack(R"({"size": [26, 12, 24],
      "blocks": [{"box": "grass_block", "min": [0, 0, 0], "max": [25, 0, 23]},
                 {"hollow": "stone", "min": [4, 0, 4], "max": [16, 8, 18]},
                 {"box": "glass", "min": [4, 3, 7], "max": [4, 5, 14]},
                 {"box": "glass", "min": [16, 3, 7], "max": [16, 5, 14]}],
      "cameras": [{"name": "eye", "position": [10.5, 4.6, 10.5], "target": [4, 4.5, 10.5], "fov": 35}],
      "environment": {"time": 2500}})",
                   options, 16, 9);
  pack.renderFrames(100);
  EXPECT_NEAR(pack.meanRadiance().g / .004572, 1, .04);
}

/// A picture of a room that the sun lights through a window of panes, over what orris trace --noise 0.003 finds.
double sunlitPanes(const char* panes, const char* camera, int channel, double traced) {
  OptionValues options = kSettling;
  options.insert_or_assign("SKY_STRENGTH", "0.0");
  options.insert_or_assign("GI_SAMPLES", "16");
  options.insert_or_assign("FACE_RAYS", "8");
  PackSession pack(fmt::format(R"({{"size": [26, 12, 24],
      "blocks": [{{"box": "grass_block", "min": [0, 0, 0], "max": [25, 0, 23]}},
                 {{"hollow": "oak_planks", "min": [4, 0, 4], "max": [16, 8, 18]}},
                 {{"box": "{}[north=true,south=true]", "min": [16, 3, 8], "max": [16, 6, 13]}}],
      "cameras": [{{"name": "eye", {}}}], "environment": {{"time": 1500}}}})",
                               panes, camera),
                   options, 16, 9);
  pack.renderFrames(100);
  return pack.meanRadiance()[channel] / traced;
}

// Sunlight comes through the holes of the outer side of a pane to the inside of the inner one, from there to that of the outer,
// and down: half of what lights the floor below.
TEST(ReferenceSunlitPanes, light_between_the_sides_of_panes_is_found) {
  const char* const floor = R"("position": [13.5, 4.6, 10.5], "target": [14, 1, 10.5], "fov": 40)";
  EXPECT_NEAR(sunlitPanes("glass_pane", floor, 1, .002499), 1, .06);
}

// A strip of the opening's side, narrower than the texels of the shadow map, which the frame of the pane shades: of what is seen of
// the pane beside it, it is half of what lights it.
TEST(ReferenceSunlitPanes, shade_the_side_of_their_opening) {
  const char* const strip =
      R"("position": [13.5, 5, 10.5], "target": [16.4375, 5.5, 8.035], "fov": 1)";
  EXPECT_NEAR(sunlitPanes("glass_pane", strip, 1, .028745), 1, .06);
}

// Of a side that the sun meets on both sides of the pane, the inner half has lost its red.
TEST(ReferenceSunlitPanes, tint_the_side_of_their_opening) {
  const char* const side = R"("position": [14.5, 5, 10.5], "target": [16.3, 5.2, 14], "fov": 3)";
  EXPECT_NEAR(sunlitPanes("lime_stained_glass_pane", side, 0, .004561), 1, .06);
}

/// A window of clear glass, and green in the mean of a picture of 16x9: orris trace --noise 0.002.
struct Skylight {
  const char* name;
  const char* glass;
  double green;
};
void PrintTo(const Skylight& skylight, std::ostream* out) { *out << skylight.name; }

class ReferenceSky : public testing::TestWithParam<Skylight> {};

// Rays pass two layers of the same texture, whose holes lie behind each other. Panes part what lights the sides of their
// opening, which are much of what is seen of low ones.
TEST_P(ReferenceSky, comes_through_clear_glass) {
  const Skylight& skylight = GetParam();
  OptionValues options = kSettling;
  options.insert_or_assign("SUN_STRENGTH", "0.0");
  options.insert_or_assign("GI_SAMPLES", "16");
  options.insert_or_assign("FACE_RAYS", "8");
  std::string world = R"({"size": [26, 12, 24],
      "blocks": [{"box": "black_concrete", "min": [0, 0, 0], "max": [25, 0, 23]},
                 {"hollow": "white_concrete", "min": [4, 0, 4], "max": [16, 8, 18]})";
  for (const int y : {2, 4, 6})
    world += fmt::format(R"(, {{"box": "{0}", "min": [4, {1}, 6], "max": [4, {1}, 16]}})",
                         skylight.glass, y);
  PackSession pack(world + R"(],
      "cameras": [{"name": "eye", "position": [6.5, 4.6, 10.5], "target": [16, 3.4, 10.7], "fov": 70}],
      "environment": {"time": 6000}})",
                   options, 16, 9);
  pack.renderFrames(100);
  const double ratio = pack.meanRadiance().g / skylight.green;
  RecordProperty("ratio", fmt::format("{:.4f}", ratio));
  EXPECT_NEAR(ratio, 1, .02);
}

INSTANTIATE_TEST_SUITE_P(, ReferenceSky,
                         testing::Values(Skylight{"glass", "glass", 0.02193},
                                         Skylight{"low_panes", "glass_pane[north=true,south=true]",
                                                  0.02532}),
                         [](const auto& tested) { return std::string(tested.param.name); });

/// What a lamp lights near it: the mean of a picture of 16x9 as orris trace finds it.
struct Spot {
  const char* name;
  const char* blocks;
  const char* camera;
  double green;
  double error;  ///< relative
};
void PrintTo(const Spot& spot, std::ostream* out) { *out << spot.name; }

class ReferenceSpot : public testing::TestWithParam<Spot> {};

TEST_P(ReferenceSpot, is_as_bright_as_in_the_path_tracer) {
  const Spot& spot = GetParam();
  PackSession pack(stoneRoom(spot.blocks, spot.camera), kSettling, 16, 9);
  pack.renderFrames(60);
  EXPECT_NEAR(pack.meanRadiance().g / spot.green, 1, spot.error);
}

// The edge of its shadow crosses the side of a block of glass.
constexpr const char* kPillarBeforeGlass =
    R"({"box": "white_stained_glass", "min": [2, 2, 4], "max": [8, 6, 4]},
       {"box": "stone", "min": [6, 2, 6], "max": [6, 6, 6]}, {"block": "end_rod", "at": [7, 4, 8]})";

INSTANTIATE_TEST_SUITE_P(
    , ReferenceSpot,
    testing::Values(
        Spot{"floor_below_a_torch", R"({"block": "torch", "at": [5, 2, 4]})",
             R"("position": [8, 5, 7], "target": [8, 2, 6.3], "fov": 20)", .01355, .025},
        Spot{"wall_beside_lava", R"({"box": "lava", "min": [3, 1, 3], "max": [6, 1, 6]})",
             R"("position": [6, 4, 8.5], "target": [2, 3.5, 5], "fov": 30)", .1308, .03},
        Spot{"side_of_leaves_below_a_lamp",
             R"({"block": "oak_leaves", "at": [5, 2, 4]}, {"block": "glowstone", "at": [5, 7, 4]})",
             R"("position": [5.5, 2.6, 7.5], "target": [5.5, 2.5, 5], "fov": 16)", .00702, .1},
        Spot{
            "behind_stained_panes",
            R"({"box": "red_stained_glass_pane[east=true,west=true]", "min": [2, 2, 4], "max": [8, 6, 4]},
                            {"block": "glowstone", "at": [5, 7, 3]})",
            R"("position": [5.5, 4, 5.5], "target": [5.5, 2, 7], "fov": 60)", .0002045, .06},
        Spot{"behind_panes",
             R"({"box": "glass_pane[east=true,west=true]", "min": [2, 2, 4], "max": [8, 6, 4]},
                            {"block": "glowstone", "at": [5, 7, 3]})",
             R"("position": [5.5, 4, 5.5], "target": [5.5, 2, 7], "fov": 60)", .007447, .04},
        Spot{"behind_panes_before_a_lamp",
             R"({"box": "glass_pane[east=true,west=true]", "min": [2, 2, 4], "max": [8, 6, 4]},
                            {"block": "glowstone", "at": [5, 4, 1]})",
             R"("position": [5.5, 4, 5.5], "target": [5.5, 3.5, 8], "fov": 60)", .008315, .04},
        Spot{"glass_beside_the_shadow_of_a_pillar", kPillarBeforeGlass,
             R"("position": [8.3, 4.5, 6.5], "target": [6.93, 4.5, 5], "fov": 2)", .2319, .04},
        Spot{"glass_in_the_shadow_of_a_pillar", kPillarBeforeGlass,
             R"("position": [8.3, 4.5, 6.5], "target": [6.5, 4.5, 5], "fov": 2)", .01783, .06}),
    [](const auto& tested) { return std::string(tested.param.name); });

// Two places of one side of a block of glass: .01956 and .02129 in green by orris trace --noise 0.005; with one value a
// side the first shows more.
TEST(ReferenceGlassSide, light_changes_over_the_side_of_a_block) {
  OptionValues options = kSettling;
  options["FACE_GAIN"] =
      "1.0";  // a plain mean of the updates: the two values differ by little more than their noise
  PackSession pack(
      stoneRoom(R"({"box": "light_blue_stained_glass", "min": [2, 2, 4], "max": [8, 6, 4]},
                                {"block": "glowstone", "at": [5, 7, 8]})",
                R"("position": [5.5, 3.6, 7.5])"),
      options, 8, 8);
  pack.look({5.5, 3.6, 7.5}, {3.25, 4.5, 5});
  pack.renderFrames(120);
  const double far = pack.meanRadiance().g;
  pack.look({5.5, 3.6, 7.5}, {3.75, 4.5, 5});
  pack.renderFrames(8);
  EXPECT_NEAR(far / pack.meanRadiance().g, .919, .08);
}

class Reference : public testing::TestWithParam<View> {};

TEST_P(Reference, is_what_the_method_draws) {
  const View& view = GetParam();
  Diagnostics diagnostics;
  const auto reference = readReference(
      fmt::format(ORRIS_SOURCE_DIR "/tests/shaderpack/references/{}.exr", view.picture),
      diagnostics);
  ASSERT_TRUE(reference && reference->hasHalves);
  const ImageF picture = drawn(view);
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const Errors errors = errorsOf(picture, *reference, channel);
    RecordProperty(fmt::format("errors{}", channel),
                   fmt::format("{:.4f} {:.4f}", errors.mean, errors.rms));
    EXPECT_NEAR(errors.mean, 0, view.mean) << "channel " << channel << ", rms " << errors.rms;
    EXPECT_LT(errors.rms, view.rms) << "channel " << channel;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Views, Reference,
    testing::Values(View{"house", "h4_house", 1, "h4_house", "FACE_CACHE", 4, .03, .06},
                    View{"hall", "deep_hall", 1, "deep_hall", "FACE_CACHE", 8, .02, .07},
                    View{"bend", "bend_grey", 0, "bend_grey", "FACE_CACHE", 8, .02, .03},
                    View{"cave", "lava_cave", 1, "lava_cave", "FACE_CACHE", 4, .05, .06},
                    View{"chapel", "chapel", 0, "chapel", "FACE_CACHE", 8, .05, .08},
                    View{"two_bounces", "h4_house", 1, "h4_house_2", "BOUNCE_2", 32, .035, .09},
                    View{"four_bounces", "h4_house", 1, "h4_house_4", "BOUNCE_4", 32, .035, .09},
                    View{"one_bounce", "h4_house", 1, "h4_house_1", "BOUNCE_1", 32, .035, .09},
                    View{"floodfill", "h4_house", 1, "h4_house", "FLOODFILL", 8, .4, .45}),
    [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace orris::test
