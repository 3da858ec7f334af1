// What the options do to pictures, and that unused methods cost nothing.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/gtc/packing.hpp>

#include "pack_session.h"
#include <orris/render/inspect/counters.h>

namespace orris::test {
namespace {

bool mentions(const Schedule& schedule, const ShaderPack& pack, const std::string& program) {
  return std::any_of(schedule.programs.begin(), schedule.programs.end(),
                     [&](int index) { return pack.programs[index].name == program; });
}

// Middles of two faces of the cornell world's blocks and of eyes that see them: the tall block's face
// toward the red wall and the short one's toward the green wall.
const glm::dvec3 kRedSide(3, 3, 5), kRedEye(1.4, 3.2, 9.5);
const glm::dvec3 kGreenSide(13, 2, 9), kGreenEye(14.5, 2.2, 13);

/// Red over green of one face, over that of the other: 1 without colour bleeding.
double colourBleeding(const std::string& method, int frames) {
  PackSession pack = PackSession::ofWorld("cornell", {{"GI_METHOD", method}}, 32, 32);
  const auto redOverGreen = [&](glm::dvec3 eye, glm::dvec3 face) {
    pack.look(eye, face);
    pack.renderFrames(frames);
    const glm::dvec3 mean = pack.meanRadiance();
    return mean.r / mean.g;
  };
  return redOverGreen(kRedEye, kRedSide) / redOverGreen(kGreenEye, kGreenSide);
}

TEST(PackPicture, floodfill_bleeds_the_walls_onto_the_blocks) {
  EXPECT_GT(colourBleeding("FLOODFILL", 60), 1.5);
}

TEST(PackPicture, four_bounces_bleed_more) { EXPECT_GT(colourBleeding("BOUNCE_4", 30), 3); }

TEST(PackPicture, lightmap_alone_does_not_bleed) { EXPECT_NEAR(colourBleeding("NONE", 2), 1, 0.1); }

/// Share of the picture's values that half floats hold.
double shareOfHalfFloats(const char* temporalFrames, const char* method = "BOUNCE_1") {
  PackSession pack = PackSession::ofWorld("cornell", {{"GI_METHOD", method}, {"TEMPORAL_FRAMES", temporalFrames}}, 32, 18);
  pack.renderFrames(3);
  const std::vector<float> values = pack.dump("colortex0").pixels;
  const auto isHalf = [](float value) { return glm::unpackHalf1x16(glm::packHalf1x16(value)) == value; };
  return double(std::count_if(values.begin(), values.end(), isHalf)) / double(values.size());
}

// Alpha is 1. In half floats blue of 1e-6 beside red of 3e-4 is wrong by up to 3 %, in every frame by the same.
TEST(PackPicture, is_in_floats_where_many_frames_are_averaged) {
  EXPECT_EQ(shareOfHalfFloats("64"), 1);
  EXPECT_LT(shareOfHalfFloats("256"), .3);
  EXPECT_EQ(shareOfHalfFloats("256", "NONE"), 1) << "nothing is averaged";
}

// Where a quad is a pixel or two wide, rasterisers move its corners by a thousandth of it, and the middle of a pixel may lie
// beyond its end in the texture.
TEST(PackPicture, no_pixel_of_a_wall_shows_the_texture_beside_its_own) {
  PackSession pack(R"({"size": [26, 12, 24],
      "blocks": [{"box": "grass_block", "min": [0, 0, 0], "max": [25, 0, 23]},
                 {"hollow": "white_concrete", "min": [4, 0, 4], "max": [16, 8, 18]}],
      "cameras": [{"name": "eye", "position": [6.5, 4.6, 10.5], "target": [16, 3.5, 10.5], "fov": 70}]})",
                   {{"GI_METHOD", "NONE"}}, 16, 9);
  pack.renderFrames(1);
  const ImageF albedo = pack.dump("colortex1");
  for (std::size_t i = 0; i < albedo.pixels.size(); i += 4)
    EXPECT_NEAR(albedo.pixels[i], albedo.pixels[0], .1F) << i / 4;
}

// Radiance 16 at level 15, of a portal (11) 16 * (11 / 15)^2 = 8.6 times its texture, which is violet and .7 to .8 dense;
// by the lightmap alone it would have a seventeenth.
TEST(PackPicture, portals_shine_where_the_camera_sees_them) {
  PackSession pack(R"({"size": [9, 7, 9],
      "blocks": [{"hollow": "black_concrete", "min": [0, 0, 0], "max": [8, 6, 8]},
                 {"box": "nether_portal[axis=x]", "min": [1, 1, 4], "max": [7, 5, 4]}],
      "cameras": [{"name": "eye", "position": [4.5, 3.5, 6.5]}],
      "environment": {"time": 18000}})",
                   {{"GI_METHOD", "NONE"}});
  pack.look({4.5, 3.5, 6.5}, {4.5, 3.5, 4.6});
  pack.renderFrames(1);
  const glm::dvec3 seen = pack.meanRadiance();
  EXPECT_GT(seen.b, 2);
  EXPECT_LT(seen.b, 8.6);
  EXPECT_GT(seen.b, 2 * seen.g);
}

/// The brightest value of the sky above a meadow.
double brightestOfSky(const char* directLight, int time) {
  PackSession pack(fmt::format(R"({{"size": [8, 2, 8],
      "blocks": [{{"box": "grass_block", "min": [0, 0, 0], "max": [7, 0, 7]}}],
      "cameras": [{{"name": "eye", "position": [4, 1.6, 4], "pitch": -90, "fov": 150}}],
      "environment": {{"time": {}}}}})", time),
                   {{"GI_METHOD", "NONE"}, {"DIRECT_LIGHT", directLight}}, 96, 96);
  pack.renderFrames(1);
  const std::vector<float> values = pack.dump("colortex0").pixels;
  double brightest = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (i % 4 != 3) brightest = std::max(brightest, double(values[i]));
  return brightest;
}

// As in the reference: a pixel of the sun in a window would be the whole error of a picture of indirect light.
TEST(PackPicture, without_direct_light_has_no_sun_moon_and_stars) {
  EXPECT_GT(brightestOfSky("PHONG", 6000), 2) << "the sun";
  EXPECT_LT(brightestOfSky("NONE", 6000), 1);
  EXPECT_GT(brightestOfSky("PHONG", 18000), .1) << "moon and stars";
  EXPECT_LT(brightestOfSky("NONE", 18000), .02);
}

// A floor under a low sun, which every shadow bias must leave unshadowed, and a wall on it.
const char* const kSunWorld = R"({
  "size": [64, 4, 64],
  "blocks": [{"box": "white_concrete", "min": [0, 0, 0], "max": [63, 0, 63]},
             {"box": "stone", "min": [40, 1, 0], "max": [40, 2, 20]}],
  "cameras": [{"name": "eye", "position": [30, 6, 50], "yaw": 180, "pitch": 60}],
  "environment": {"time": 700}
})";

glm::dvec3 floorRadiance(const OptionValues& options, glm::dvec3 eye, glm::dvec3 floor) {
  OptionValues all = options;
  all.emplace("GI_METHOD", "NONE");
  PackSession pack(kSunWorld, all);
  pack.look(eye, floor);
  pack.renderFrames(1);
  return pack.meanRadiance();
}

TEST(PackPicture, no_bias_puts_shadows_on_an_open_floor) {
  const glm::dvec3 eye(30, 6, 50), floor(30, 1, 46);
  const double lit = floorRadiance({{"SHADOW_METHOD", "NONE"}}, eye, floor).g;
  for (const char* method : {"MAP", "MAP_PCF"})
    for (const char* bias : {"PUBLISHED", "NORMAL_OFFSET"})
      EXPECT_NEAR(
          floorRadiance({{"SHADOW_METHOD", method}, {"SHADOW_BIAS", bias}}, eye, floor).g / lit, 1,
          1e-4)
          << method << ' ' << bias;
}

TEST(PackPicture, published_bias_detaches_the_shadow_of_a_wall) {
  // The sun is in the east (+x): west of the wall, at its foot.
  const glm::dvec3 eye(36, 4, 14), floor(39.5, 1, 10);
  const double lit = floorRadiance({{"SHADOW_METHOD", "NONE"}}, eye, floor).g;
  EXPECT_LT(floorRadiance({{"SHADOW_BIAS", "NORMAL_OFFSET"}}, eye, floor).g / lit, 0.9);
  EXPECT_NEAR(floorRadiance({{"SHADOW_BIAS", "PUBLISHED"}}, eye, floor).g / lit, 1, 1e-4);
}

TEST(PackPicture, sun_stays_out_of_a_closed_room_without_shadows) {
  const char* const world = R"({
    "size": [7, 7, 7],
    "blocks": [{"hollow": "white_concrete", "min": [0, 0, 0], "max": [6, 6, 6]}],
    "cameras": [{"name": "eye", "position": [3.5, 4, 3.5], "yaw": 0, "pitch": 90}],
    "environment": {"time": 6000}
  })";
  for (const char* method : {"NONE", "FLOODFILL"}) {
    PackSession pack(world, {{"SHADOW_METHOD", "NONE"}, {"GI_METHOD", method}});
    pack.renderFrames(1);
    EXPECT_LT(pack.meanRadiance().g, 0.01) << method;
  }
}

// A red wall before a green one.
TEST(PackPicture, view_of_the_volume_shows_what_rays_meet_beyond_a_distance) {
  const char* const world = R"({
    "size": [9, 7, 9],
    "blocks": [{"hollow": "white_concrete", "min": [0, 0, 0], "max": [8, 6, 8]},
               {"box": "lime_concrete", "min": [1, 1, 0], "max": [7, 5, 0]},
               {"box": "red_concrete", "min": [1, 1, 4], "max": [7, 5, 4]},
               {"block": "glowstone", "at": [4, 6, 2]}],
    "cameras": [{"name": "eye", "position": [4.5, 3.5, 7.5], "yaw": 180, "pitch": 0, "fov": 30}],
    "environment": {"time": 18000}
  })";
  const auto seen = [&](const char* method, const char* view, const char* from) {
    PackSession pack(world,
                     {{"GI_METHOD", method}, {"VOXEL_VIEW", view}, {"VOXEL_VIEW_FROM", from}});
    pack.renderFrames(40);
    return pack.meanRadiance();
  };
  const glm::dvec3 near = seen("FACE_CACHE", "BLOCKS", "0.0");
  EXPECT_GT(near.r, 3 * near.g);
  const glm::dvec3 far = seen("FACE_CACHE", "BLOCKS", "4.0");
  EXPECT_GT(far.g, 1.5 * far.r);
  // Only behind the red wall there is light.
  for (const char* method : {"FACE_CACHE", "FLOODFILL"}) {
    EXPECT_LT(seen(method, "RADIANCE", "0.0").g, .01) << method;
    EXPECT_GT(seen(method, "RADIANCE", "4.0").g, .1) << method;
  }
}

// A volume of 256 x 128 x 256: a red wall 110 blocks to the east, a green one 70 blocks above.
TEST(PackPicture, largest_volume_is_wider_than_high) {
  const char* const world = R"({
    "size": [224, 104, 8],
    "blocks": [{"box": "red_concrete", "min": [220, 0, 0], "max": [220, 60, 7]},
               {"box": "lime_concrete", "min": [100, 101, 0], "max": [120, 101, 7]}],
    "cameras": [{"name": "eye", "position": [110, 30, 4], "yaw": 0, "pitch": 0}],
    "environment": {"time": 18000}
  })";
  const auto drawnWith = [&](const char* volume, const char* walk) {
    return PackSession(world, {{"GI_METHOD", "BOUNCE_1"},
                               {"VOXEL_VIEW", "BLOCKS"},
                               {"VOXEL_SIZE", volume},
                               {"RAY_WALK", walk},
                               {"SHADOW_RESOLUTION", "4096"},
                               {"SHADOW_DISTANCE", "128.0"}});
  };
  const auto seen = [](PackSession& pack, glm::dvec3 at) {
    pack.look({110, 30, 4}, at);
    pack.renderFrames(2);
    return pack.meanRadiance();
  };
  const glm::dvec3 east(220, 30, 4), up(110.1, 101, 4);
  for (const char* walk : {"GRID", "DISTANCE"}) {
    PackSession pack = drawnWith("256", walk);
    const glm::dvec3 wall = seen(pack, east);
    EXPECT_GT(wall.r, .05) << walk;
    EXPECT_GT(wall.r, 3 * wall.g) << walk;
    EXPECT_EQ(seen(pack, up), glm::dvec3(0)) << walk;
  }
  PackSession smaller = drawnWith("128", "DISTANCE");
  EXPECT_EQ(seen(smaller, east), glm::dvec3(0));
}

/// A wall of concrete in the noon sun, of which the camera sees nothing else.
constexpr const char* kWall = R"({
  "size": [64, 16, 8],
  "blocks": [{"box": "white_concrete", "min": [0, 0, 0], "max": [31, 15, 0]},
             {"box": "black_concrete", "min": [32, 0, 0], "max": [63, 15, 0]}],
  "cameras": [{"name": "eye", "position": [16, 8, 4], "yaw": 180, "fov": 30}],
  "environment": {"time": 6000}
})";
const glm::dvec3 kBeforeWhite(16, 8, 4), kWhite(16, 8, 1), kBeforeBlack(48, 8, 4), kBlack(48, 8, 1);

PackSession adaptingWall() {
  return {kWall, {{"GI_METHOD", "NONE"}, {"AUTO_EXPOSURE", "true"}}};
}

/// Of the pack, for a picture of one luminance: the power .6 of how much darker it is than .45 (include/post/exposure.glsl).
double exposureFor(PackSession& pack) {
  return std::clamp(std::pow(.45 / glm::dot(pack.meanRadiance(), {.2126, .7152, .0722}), .6), .5, 4.);
}

double exposureOf(PackSession& pack) { return pack.dump("colortex9").pixels.at(0); }

TEST(AutoExposure, first_frame_has_what_its_luminance_asks_for) {
  PackSession pack = adaptingWall();
  pack.look(kBeforeWhite, kWhite);
  pack.renderFrames(1);
  EXPECT_LT(exposureFor(pack), .9);
  EXPECT_NEAR(exposureOf(pack), exposureFor(pack), .01);
}

// Frames last a sixtieth of a second, and after .4 s 1/e of the step is left.
TEST(AutoExposure, follows_a_step_of_the_luminance_exponentially) {
  PackSession pack = adaptingWall();
  pack.look(kBeforeWhite, kWhite);
  pack.renderFrames(2);
  const double bright = exposureOf(pack);
  pack.look(kBeforeBlack, kBlack);
  pack.renderFrames(1);
  const double dark = exposureFor(pack);
  ASSERT_GT(dark, 1.5 * bright);
  EXPECT_NEAR((dark - exposureOf(pack)) / (dark - bright), std::exp(-1 / 24.), .005);
  pack.renderFrames(23);
  EXPECT_NEAR((dark - exposureOf(pack)) / (dark - bright), std::exp(-1.), .01);
}

TEST(AutoExposure, exposes_the_screen) {
  const auto screenOf = [](const char* adapts) {
    PackSession pack(kWall, {{"GI_METHOD", "NONE"}, {"AUTO_EXPOSURE", adapts}, {"TONE_MAP", "NONE"}, {"SUN_STRENGTH", "0.0"},
                             {"SKY_STRENGTH", "0.25"}});
    pack.look(kBeforeWhite, kWhite);
    pack.renderFrames(2);
    return std::pair(pack.session().renderer().screenshot(), adapts == std::string("true") ? exposureOf(pack) : 1);
  };
  const auto linear = [](const Image8& screen) { return std::pow((screen.pixels.at(1) / 255. + .055) / 1.055, 2.4); };
  const auto [plain, one] = screenOf("false");
  const auto [adapted, exposure] = screenOf("true");
  ASSERT_GT(exposure, 1.5);
  EXPECT_NEAR(linear(adapted) / linear(plain) / exposure, 1, .06) << "of bytes, and one pixel of a textured wall";
}

TEST(AutoExposure, costs_nothing_without) {
  for (const char* adapts : {"true", "false"}) {
    PackSession pack(kWall, {{"GI_METHOD", "NONE"}, {"AUTO_EXPOSURE", adapts}});
    const FrameRenderer& renderer = pack.session().renderer();
    EXPECT_EQ(mentions(renderer.schedule(), renderer.pack(), "composite"), adapts == std::string("true"));
    EXPECT_EQ(bool(renderer.schedule().target(false, 9)), adapts == std::string("true"));
  }
  PackSession view(kWall, {{"GI_METHOD", "NONE"}, {"AUTO_EXPOSURE", "true"}, {"SHADOW_VIEW", "true"}});
  EXPECT_FALSE(view.session().renderer().schedule().target(false, 9)) << "a view of shadows is no picture";
}

/// A lake at noon, seen from above at a slant.
constexpr const char* kLake = R"({
  "size": [64, 8, 64],
  "blocks": [{"box": "sand", "min": [0, 0, 0], "max": [63, 3, 63]}, {"box": "water", "min": [0, 2, 0], "max": [63, 3, 31]}],
  "cameras": [{"name": "eye", "position": [32, 8, 40]}],
  "environment": {"time": 6000}
})";

/// What two frames half a second apart show of a place of the lake.
std::pair<ImageF, ImageF> lakeAt(const char* waves, glm::dvec3 eye, glm::dvec3 place) {
  PackSession pack(kLake, {{"GI_METHOD", "NONE"}, {"WATER_WAVES", waves}});
  pack.look(eye, place);
  pack.renderFrames(1);
  ImageF first = pack.dump("colortex0");
  pack.renderFrames(30);
  return {std::move(first), pack.dump("colortex0")};
}

TEST(WaterWaves, move_on_water_and_nowhere_else) {
  const glm::dvec3 eye(32, 8, 40), water(32, 4, 24), sand(32, 4, 44);
  const auto [first, later] = lakeAt("true", eye, water);
  EXPECT_NE(first.pixels, later.pixels);
  const auto [calm, calmLater] = lakeAt("false", eye, water);
  EXPECT_EQ(calm.pixels, calmLater.pixels);
  const auto [shore, shoreLater] = lakeAt("true", eye, sand);
  EXPECT_EQ(shore.pixels, shoreLater.pixels);
  EXPECT_EQ(shore.pixels, lakeAt("false", eye, sand).first.pixels);
}

/// Standard deviation over the mean of what is green.
double contrast(const ImageF& image) {
  double sum = 0, squares = 0;
  const double n = image.width * image.height;
  for (int i = 0; i < int(n); ++i) {
    const double green = image.pixels[std::size_t(i) * image.channels + 1];
    sum += green;
    squares += green * green;
  }
  return std::sqrt(std::max(0., squares / n - sum / n * sum / n)) / (sum / n);
}

// In the mirror image of the sun, waves that no pixel can show become a wider highlight: less noise far away.
TEST(WaterWaves, far_ones_do_not_flicker) {
  const auto spread = [](glm::dvec3 eye, glm::dvec3 place) { return contrast(lakeAt("true", eye, place).first); };
  const glm::dvec3 place(32, 4, 16);
  const glm::dvec3 toward(0, 8, -4.6);
  const double near = spread(place + toward, place);
  EXPECT_GT(near, .7);
  EXPECT_LT(spread(place + 15. * toward, place), .6 * near);
}

TEST(PackCost, without_lights_and_shadows_no_voxels_floodfill_or_shadow_map_exist) {
  PackSession pack =
      PackSession::ofWorld("cornell", {{"GI_METHOD", "NONE"}, {"SHADOW_METHOD", "NONE"}}, 32, 32);
  const FrameRenderer& renderer = pack.session().renderer();
  const Schedule& schedule = renderer.schedule();
  EXPECT_EQ(schedule.shadowResolution, 0);
  EXPECT_TRUE(schedule.shadowcolor.empty());
  EXPECT_FALSE(schedule.shadowtex1);
  for (const int target : {3, 4, 5}) EXPECT_FALSE(schedule.target(false, target)) << target;
  for (const char* program : {"shadow", "prepare", "deferred"})
    EXPECT_FALSE(mentions(schedule, renderer.pack(), program)) << program;
  EXPECT_TRUE(mentions(schedule, renderer.pack(), "deferred6"));
}

TEST(PackCost, shadow_map_alone_needs_no_voxels) {
  PackSession pack = PackSession::ofWorld("cornell", {{"GI_METHOD", "NONE"}}, 32, 32);
  const Schedule& schedule = pack.session().renderer().schedule();
  EXPECT_EQ(schedule.shadowResolution, 1024);
  for (const int target : {3, 4, 5}) EXPECT_FALSE(schedule.target(false, target)) << target;
  EXPECT_FALSE(mentions(schedule, pack.session().renderer().pack(), "prepare"));
}

TEST(PackCost, bounces_need_no_floodfill) {
  PackSession pack = PackSession::ofWorld("cornell", {{"GI_METHOD", "BOUNCE_2"}}, 32, 32);
  const Schedule& schedule = pack.session().renderer().schedule();
  EXPECT_TRUE(schedule.target(false, 3));
  EXPECT_FALSE(schedule.target(false, 4));
}

// A block on its own has six faces; each pixel sends a ray, and what it hits none.
TEST(PackCost, voxels_and_rays_are_counted_when_asked_for) {
  constexpr const char* kBlock = R"({
    "size": [4, 4, 4], "blocks": [{"block": "stone", "at": [1, 1, 1]}],
    "cameras": [{"name": "eye", "position": [1.5, 1.5, 2.1], "yaw": 180, "fov": 30}]})";
  OptionValues options = {{"GI_METHOD", "BOUNCE_1"}, {"GI_COUNTERS", "true"}};
  PackSession counted(kBlock, options, 8, 8);
  counted.renderFrames(2);
  const auto counts = readCounters(counted.session().renderer());
  EXPECT_EQ(counts.at("gi_state"), (std::vector<long long>{6, 64}));
  options.erase("GI_COUNTERS");
  EXPECT_TRUE(readCounters(PackSession(kBlock, options).session().renderer()).empty());
}

int volumeOf(const std::string& world) {
  PackSession pack(world, {{"GI_METHOD", "FACE_CACHE"}, {"VOXEL_SIZE", "AUTO"}});
  for (const CustomImage& image : pack.session().renderer().pack().properties.images)
    if (image.name == "face_light") return int(image.size[1]);
  return 0;
}

TEST(PackCost, no_volume_is_chosen_without_voxels) {
  PackSession pack =
      PackSession::ofWorld("cornell", {{"GI_METHOD", "NONE"}, {"VOXEL_SIZE", "AUTO"}}, 8, 8);
  EXPECT_EQ(pack.session().autoChoices().text(), "");
}

// Twice the side of what is drawn, and four cells at each end that fade.
TEST(PackCost, volume_of_voxels_is_as_large_as_the_world_needs) {
  const auto floor = [](int side, int eye) {
    return fmt::format(R"({{"size": [{0}, 4, {0}],
        "blocks": [{{"box": "stone", "min": [0, 0, 0], "max": [{1}, 0, {1}]}}],
        "cameras": [{{"name": "eye", "position": [{2}, 3, 4]}}]}})",
                       side, side - 1, eye);
  };
  EXPECT_EQ(volumeOf(floor(12, 4)), 32);
  EXPECT_EQ(volumeOf(floor(13, 4)), 48);
  EXPECT_EQ(volumeOf(floor(20, 4)), 48);
  EXPECT_EQ(volumeOf(floor(21, 4)), 64);
  EXPECT_EQ(volumeOf(floor(60, 4)), 64) << "the largest that SHADOW_RESOLUTION has room for";
  EXPECT_EQ(volumeOf(floor(12, 17)), 48) << "from outside";
}

}  // namespace
}  // namespace orris::test
