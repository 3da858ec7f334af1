// Indirect light of what is no full block: glass, water, plants, lamps in the cell where a ray begins;
// and lamps by rays to them.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "face_field.h"

namespace orris::test {
namespace {

OptionValues indirectOptions(OptionValues more = {}) {
  more.insert({{"GI_METHOD", "FACE_CACHE"},
               {"VOXEL_SIZE", std::to_string(kFaceVolume)},
               {"GI_FILTER", "false"},
               {"AMBIENT_MINIMUM", "0.0"}});
  return more;
}

/// A closed black room of 9 x 7 x 9 at night, and what else `blocks` says.
std::string darkRoom(const std::string& blocks) {
  return fmt::format(R"({{"size": [9, 7, 9],
      "blocks": [{{"hollow": "black_concrete", "min": [0, 0, 0], "max": [8, 6, 8]}}, {}],
      "cameras": [{{"name": "eye", "position": [4.5, 3.5, 6.5]}}],
      "environment": {{"time": 18000}}}})",
                     blocks);
}

// A ball of radius r and radiance L gives a point below it L r^2 h / d^3.
TEST(IndirectLight, small_lamps_light_the_floor_that_they_stand_on) {
  std::string rods = R"({"block": "end_rod[facing=up]", "at": [)";
  for (int i = 0; i < 9; ++i)
    rods += fmt::format("{}[{}, 1, {}]", i > 0 ? ", " : "", 2 + i % 3 * 2, 2 + i / 3 * 2);
  PackSession pack(
      darkRoom(rods + "]}"),
      indirectOptions({{"FACE_SHARE", "1"}, {"FACE_WINDOW", "128"}, {"FACE_GAIN", "1.0"}}));
  pack.renderFrames(130);
  double form = 0, found = 0;
  constexpr int kSteps = 32;
  for (int i = 0; i < kSteps * kSteps; ++i) {
    const double x = (i % kSteps + .5) / kSteps - .5, z = (i / kSteps + .5) / kSteps - .5;
    form += .5 / std::pow(x * x + z * z + .25, 1.5) / 16 / (kSteps * kSteps);
  }
  const FaceField field = faceField(pack, kFaceVolume);
  for (int i = 0; i < 9; ++i) found += field.red({2 + i % 3 * 2, 0, 2 + i / 3 * 2}, kUp) / 9;
  const double lamp = 5 * 16 * 14 * 14 / 225.0;
  EXPECT_NEAR(found / (lamp * form), 1, .2);
}

// From the floor of a shaft to the lamp at its end, glass in between: every ray has 1 to sqrt(3) blocks of
// glass on its way, in the cell where it begins.
TEST(IndirectLight, glass_takes_light_where_a_ray_begins) {
  const auto floorLight = [](const std::string& filling) {
    PackSession pack(
        fmt::format(R"({{"size": [9, 7, 9],
        "blocks": [{{"box": "black_concrete", "min": [0, 0, 0], "max": [8, 3, 8]}},
                   {{"block": "glowstone", "at": [4, 3, 4]}}, {{"block": "air", "at": [4, 2, 4]}},
                   {{"block": "{}", "at": [4, 1, 4]}}],
        "cameras": [{{"name": "eye", "position": [4.5, 4.5, 6.5]}}],
        "environment": {{"time": 18000}}}})",
                    filling),
        indirectOptions({{"FACE_SHARE", "1"}, {"FACE_WINDOW", "128"}, {"FACE_GAIN", "1.0"}}));
    pack.renderFrames(150);
    const float stored = pack.voxels({.volume = kFaceVolume, .columns = 32})
                             .red(cellOf({4, 1, 4}, {4, 4, 6}, kFaceVolume));
    return std::pair(double(faceField(pack, kFaceVolume).red({4, 0, 4}, kUp)),
                     std::pow(double(stored), 4));  // a tint is kept as its fourth root
  };
  const auto [clear, none] = floorLight("air");
  const auto [tinted, color] = floorLight("light_gray_stained_glass");
  ASSERT_LT(color, .6);
  ASSERT_GT(color, .1);
  EXPECT_LT(tinted / clear, 1.05 * color);
  EXPECT_GT(tinted / clear, .9 * std::pow(color, std::sqrt(3.0)));
}

/// Mean of a narrow view, over frames after the cache has settled.
glm::dvec3 seen(const std::string& world, const OptionValues& more, glm::dvec3 eye, glm::dvec3 at) {
  PackSession pack(world, indirectOptions(more));
  pack.look(eye, at);
  pack.renderFrames(90);
  return pack.meanRadiance();
}

// The lightmap has every lamp orange.
TEST(IndirectLight, glass_and_water_have_the_colour_of_the_lamp) {
  for (const char* block : {"white_stained_glass", "water"}) {
    const std::string world =
        darkRoom(fmt::format(R"({{"box": "black_concrete", "min": [1, 1, 1], "max": [7, 1, 7]}},
            {{"box": "{}", "min": [3, 1, 1], "max": [5, 1, 5]}},
            {{"box": "verdant_froglight", "min": [1, 6, 1], "max": [7, 6, 7]}})",
                             block));
    const glm::dvec3 light = seen(world, {}, {4.5, 5.5, 4.5}, {4.5, 2, 3.6});
    EXPECT_GT(light.g, 1.5 * light.r) << block;
    EXPECT_GT(light.g, .01) << block;
  }
}

// Before rays of its own have been averaged, it shows what its faces hold.
TEST(IndirectLight, glass_just_come_into_view_is_as_bright_as_later) {
  PackSession pack(darkRoom(R"({"box": "black_concrete", "min": [1, 1, 1], "max": [7, 1, 7]},
            {"box": "white_stained_glass", "min": [3, 1, 1], "max": [5, 1, 5]},
            {"box": "verdant_froglight", "min": [1, 6, 1], "max": [7, 6, 7]})"),
                   indirectOptions());
  pack.look({4.5, 5.5, 4.5}, {4.5, 3.5, 8});
  pack.renderFrames(60);
  pack.look({4.5, 5.5, 4.5}, {4.5, 2, 3.6});
  pack.renderFrames(1);
  const double first = pack.meanRadiance().g;
  pack.renderFrames(60);
  EXPECT_NEAR(first / pack.meanRadiance().g, 1, .15);
}

// Light to the bed of a lake takes its colour over the whole way, also through cells that have no faces.
TEST(IndirectLight, deep_water_takes_light_by_the_way_through_it) {
  const auto bed = [](const std::string& water) {
    PackSession pack(
        darkRoom(R"({"box": "glowstone", "min": [1, 6, 1], "max": [7, 6, 7]})" + water),
        indirectOptions({{"FACE_SHARE", "1"}, {"FACE_WINDOW", "128"}, {"FACE_GAIN", "1.0"}}));
    pack.renderFrames(130);
    return double(faceField(pack, kFaceVolume).at({4, 0, 4}, kUp)[2]);
  };
  const double dry = bed("");
  const double shallow = bed(R"(,{"box": "water", "min": [1, 1, 1], "max": [7, 1, 7]})") / dry;
  const double deep = bed(R"(,{"box": "water", "min": [1, 1, 1], "max": [7, 3, 7]})") / dry;
  ASSERT_GT(shallow, .05);
  ASSERT_LT(shallow, .9);
  // 8/9 and 26/9 of a block, aslant a little more.
  EXPECT_LT(deep, std::pow(shallow, 2.2));
  EXPECT_GT(deep, std::pow(shallow, 4.5));
}

// At a flat angle water shows what is behind it: here a wall of lamps.
TEST(IndirectLight, water_mirrors_the_blocks_behind_it) {
  const auto lit = [](const std::string& wall) {
    return seen(darkRoom(R"({"box": "water", "min": [1, 1, 1], "max": [7, 1, 7]},
                            {"box": ")" +
                         wall + R"(", "min": [1, 2, 0], "max": [7, 4, 0]})"),
                {}, {4.5, 2.6, 7.5}, {4.5, 1.9, 4.2})
        .r;
  };
  EXPECT_GT(lit("glowstone"), 1);
  EXPECT_LT(lit("black_concrete"), .01);
}

// Grass between the eye and a wall of lamps is seen by the light that passes it: about as bright as
// with the lamps at the eye's side.
TEST(IndirectLight, plants_pass_light) {
  const auto lit = [](int z) {
    return seen(
               darkRoom(fmt::format(
                   R"({{"block": "grass_block", "at": [4, 1, 4]}}, {{"block": "fern", "at": [4, 2, 4]}},
                        {{"box": "glowstone", "min": [1, 4, {0}], "max": [7, 5, {0}]}})",
                   z)),
               {{"GI_SAMPLES", "4"}}, {4.5, 2.5, 7.0}, {4.5, 2.4, 4.5})
        .g;
  };
  const double behind = lit(0), before = lit(8);
  EXPECT_GT(behind / before, .6);
  EXPECT_LT(behind / before, 1.6);
}

/// Mean and spread over frames of the middle pixel of a room's floor.
std::pair<double, double> floorOverFrames(const std::string& lamps) {
  PackSession pack(darkRoom(R"({"box": "stone", "min": [1, 0, 1], "max": [7, 0, 7]},
                               {"block": "glowstone", "at": [4, 5, 4]}, {"block": "lantern", "at": [6, 1, 2]})"),
                   indirectOptions({{"GI_LAMPS", lamps}, {"GI_SAMPLES", "2"}, {"TEMPORAL_ACCUMULATION", "false"}}));
  pack.look({4.5, 4.5, 7.0}, {3.5, 1, 4});
  pack.renderFrames(60);
  double sum = 0, squares = 0;
  constexpr int kFrames = 96;
  int count = 0;
  for (int i = 0; i < kFrames; ++i) {
    pack.renderFrames(1);
    const ImageF image = pack.dump("colortex3");
    for (std::size_t p = 0; p < image.pixels.size(); p += std::size_t(image.channels), ++count) {
      sum += image.pixels[p];
      squares += double(image.pixels[p]) * image.pixels[p];
    }
  }
  const double mean = sum / count;
  return {mean, std::sqrt(squares / count - mean * mean) / mean};
}

TEST(IndirectLight, rays_to_lamps_count_each_once_and_take_away_noise) {
  const auto [hit, hitNoise] = floorOverFrames("HIT");
  const auto [sampled, sampledNoise] = floorOverFrames("SAMPLED");
  EXPECT_NEAR(sampled / hit, 1, .06);
  EXPECT_LT(sampledNoise, .4 * hitNoise);
}

// On the foot of a wall, beside a lamp in it: the floor there is far darker than the mean of its block's face.
TEST(IndirectLight, corners_beside_a_lamp_are_as_dark_as_with_more_bounces) {
  const auto foot = [](OptionValues more) {
    more.insert({{"TEMPORAL_FRAMES", "1024"}, {"GI_SAMPLES", "4"}});
    PackSession pack(darkRoom(R"({"box": "white_concrete", "min": [1, 0, 1], "max": [7, 0, 7]},
                                 {"box": "white_concrete", "min": [0, 1, 1], "max": [0, 5, 7]},
                                 {"block": "glowstone", "at": [0, 1, 4]})"),
                     indirectOptions(std::move(more)), 16, 16);
    pack.look({1.5, 1.1, 5.5}, {1, 1.05, 5.5});
    pack.renderFrames(300);
    return pack.meanRadiance().g;
  };
  const double reference = foot({{"GI_METHOD", "BOUNCE_4"}});
  EXPECT_GT(foot({{"FACE_NEAR", "0.0"}}) / reference, 1.15);
  EXPECT_NEAR(foot({}) / reference, 1, .1);
}

// Behind two layers of yellow glass blue is so dark that half floats have few steps for it; a lamp 32 times as strong is as
// much brighter there.
TEST(IndirectLight, light_too_dark_for_half_floats_is_in_proportion_to_its_lamp) {
  const auto blue = [](const char* strength) {
    PackSession pack(R"({"size": [11, 9, 11],
        "blocks": [{"hollow": "stone", "min": [1, 1, 1], "max": [9, 7, 9]},
                   {"box": "yellow_stained_glass", "min": [2, 2, 4], "max": [8, 6, 5]},
                   {"block": "glowstone", "at": [5, 7, 3]}],
        "cameras": [{"name": "eye", "position": [5.5, 4, 6.5], "target": [5.5, 2, 7.6], "fov": 60}],
        "environment": {"time": 18000}})",
                     indirectOptions({{"EMISSION_STRENGTH", strength},
                                      {"FACE_SHARE", "1"},
                                      {"TEMPORAL_FRAMES", "1024"},
                                      {"GI_SAMPLES", "4"}}),
                     16, 9);
    pack.renderFrames(160);
    const ImageF image = pack.dump("colortex3");
    double sum = 0;
    for (std::size_t p = 2; p < image.pixels.size(); p += std::size_t(image.channels))
      sum += image.pixels[p];
    return sum;
  };
  EXPECT_NEAR(blue("64.0") / blue("2.0"), 32, 1);
}

// Means over 128 frames are kept in half floats, those over 1024 are not.
TEST(IndirectLight, means_over_frames_lose_nothing_in_half_floats) {
  const auto mean = [](const char* frames) {
    PackSession pack(
        R"({"size": [32, 1, 32],
        "blocks": [{"box": "white_concrete", "min": [0, 0, 0], "max": [31, 0, 31]}],
        "cameras": [{"name": "eye", "position": [16.5, 6.5, 16.5], "target": [15.5, 1, 16]}],
        "environment": {"time": 3000}})",
        indirectOptions(
            {{"GI_METHOD", "BOUNCE_1"}, {"DIRECT_LIGHT", "NONE"}, {"TEMPORAL_FRAMES", frames}}),
        64, 36);
    pack.renderFrames(300);
    return pack.meanRadiance().g;
  };
  EXPECT_NEAR(mean("128") / mean("1024"), 1, .006);
}

// Under the sky alone both gather the same light, and keep the same means over frames.
TEST(IndirectLight, rays_of_a_pixel_are_spread_over_frames) {
  const auto noise = [](const char* method) {
    PackSession pack(R"({"size": [32, 1, 32],
        "blocks": [{"box": "white_concrete", "min": [0, 0, 0], "max": [31, 0, 31]}],
        "cameras": [{"name": "eye", "position": [16.5, 6.5, 16.5]}], "environment": {"time": 3000}})",
                     indirectOptions({{"GI_METHOD", method}, {"DIRECT_LIGHT", "NONE"}}));
    pack.look({16.5, 6.5, 16.5}, {15.5, 1, 16});
    pack.renderFrames(160);
    const ImageF image = pack.dump("colortex3");
    double sum = 0, squares = 0;
    const auto step = std::size_t(image.channels);
    for (std::size_t p = 0; p < image.pixels.size(); p += step) {
      sum += image.pixels[p];
      squares += double(image.pixels[p]) * image.pixels[p];
    }
    const double count = double(image.pixels.size() / step), mean = sum / count;
    return std::sqrt(squares / count - mean * mean) / mean;
  };
  const double independent = noise("BOUNCE_1");
  EXPECT_GT(independent, .01);
  EXPECT_LT(noise("FACE_CACHE"), .4 * independent);
}

}  // namespace
}  // namespace orris::test
