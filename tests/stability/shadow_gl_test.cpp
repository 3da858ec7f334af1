// Shadow maps where they fail: acne, detachment, borders, crawling. T is the side of a texel, D the
// depth of the map, theta the angle between the sun and the normal.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <set>

#include "lab.h"
#include "shadow_lab.h"

namespace orris::test {
namespace {

constexpr int kRadius = 1;
const char* const kShadow = "/include/shadow/shadow.glsl";
// Across the sun's way, in the middle of the floor.
const char* const kWall = R"({"box": "stone", "min": [32, 2, 8], "max": [32, 9, 55]})";

double radians(double degrees) { return degrees * glm::pi<double>() / 180; }

/// What a plane needs so that no tap of the filter is behind the light's ray, in blocks (C1).
double leastBias(double theta, double texel) {
  return (kRadius + 0.5) * texel * std::tan(radians(theta));
}

/// The published bias, 0..1 of the depth.
double publishedBias(double theta) {
  return std::max(0.05 * (1 - std::cos(radians(theta))), 0.005);
}

/// Where the published bias no longer hides a plane: it grows to 0.05, the tangent without end.
double publishedLimit(double texel) {
  double low = 45, high = 90;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (publishedBias(middle) * kDepth > leastBias(middle, texel) ? low : high) = middle;
  }
  return low;
}

/// Blocks of floor west of the wall's foot that are lit, by a row of points 1/32 apart.
double litStrip(ShadowLab& lab, int points) {
  for (int x = 0; x < points; ++x)
    if (lab.at(x)[0] < 0.5) return (x + 0.5) / 32;
  return points / 32.0;
}

const char* const kBehindTheWall =
    "vec4(lit(vec3(32.0 - (float(pixel.x) + 0.5) / 32.0, 2.0, 32.0), vec3(0.0, 1.0, 0.0)))";

class ShadowBias : public testing::TestWithParam<int> {};

// Row C1 of docs/failure-modes.md.
// Column: where in a texel; row: the bias, as a share of the predicted one.
TEST_P(ShadowBias, least_bias_of_a_plane_is_the_predicted_one) {
  constexpr int kRows = 80;
  ShadowLab lab(
      {.sun = double(GetParam()),
       .probe = "biased(pixel)",
       .functions = fmt::format("vec4 biased(ivec2 pixel) {{\n"
                                "    test_bias = (float(pixel.y) + 20.0) / 60.0 * {};\n"
                                "    float x = 30.0 + float(pixel.x) * 0.1271;\n"
                                "    return vec4(lit(vec3(x, 2.0, 32.0), vec3(0.0, 1.0, 0.0)));\n"
                                "}}\n",
                                leastBias(GetParam(), kTexel)),
       .change =
           [](PackTexts& files) {
             edit(files[kShadow], "player += normal * (reach", "player += 0.0 * (reach");
             edit(files[kShadow], "float bias = 0.01 * depth_per_block",
                  "float bias = test_bias * depth_per_block");
             edit(files[kShadow], "/// Receiver and bias",
                  "float test_bias;\n/// Receiver and bias");
           },
       .width = 96,
       .height = kRows});
  lab.draw();
  int first = kRows;
  while (first > 0) {
    bool clean = true;
    for (int x = 0; x < 96; ++x) clean = clean && lab.at(x, first - 1)[0] == 1;
    if (!clean) break;
    --first;
  }
  EXPECT_NEAR((first + 20) / 60.0, 1, .05);
}

// Row C3 of docs/failure-modes.md.
TEST_P(ShadowBias, normal_offset_has_neither_acne_nor_detached_shadows) {
  ShadowLab floor({.sun = double(GetParam()),
                   .probe = "vec4(lit(vec3(20.0, 2.0, 20.0) + 0.0731 * vec3(pixel.x, 0.0, pixel.y),"
                            " vec3(0.0, 1.0, 0.0)))",
                   .width = 64,
                   .height = 64});
  floor.draw();
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) ASSERT_EQ(floor.at(x, y)[0], 1) << x << ' ' << y;
  ShadowLab wall(
      {.blocks = kWall, .sun = double(GetParam()), .probe = kBehindTheWall, .width = 64});
  wall.draw();
  EXPECT_LE(litStrip(wall, 64), kTexel);
}

INSTANTIATE_TEST_SUITE_P(, ShadowBias, testing::Values(5, 45, 60, 75, 85));

const char* const kPoint =
    "float lit_point(vec3 world) {\n"
    "    PlaneInMap plane = plane_in_map(world - cameraPosition, vec3(0.0, 1.0, 0.0));\n"
    "    return point_visibility(plane, depth_in_texel(plane, floor(plane.position)), 1.0);\n"
    "}\n";

class ShadowOfPoints : public testing::TestWithParam<int> {};

// What rays hit: no offset from the plane makes shadows shorter. Walls of eight heights, as each edge falls somewhere
// within a texel.
TEST_P(ShadowOfPoints, is_as_long_as_geometry_says) {
  constexpr int kWalls = 8, kPoints = 384, kFirst = 4, kEveryBlock = 8;
  std::string walls;
  for (int i = 0; i < kWalls; ++i)
    walls += fmt::format(R"({}{{"box": "stone", "min": [48, 2, {}], "max": [48, {}, {}]}})", i > 0 ? ", " : "", 12 + 5 * i,
                         1 + kFirst + i, 14 + 5 * i);
  ShadowLab lab({.blocks = walls,
                 .sun = double(GetParam()),
                 .probe = fmt::format("vec4(lit_point(vec3(48.0 - (float(pixel.x) + 0.5) / {}.0, 2.0, "
                                      "13.5 + 5.0 * float(pixel.y))))",
                                      kEveryBlock),
                 .functions = kPoint,
                 .width = kPoints,
                 .height = kWalls});
  lab.draw();
  const double slope = std::tan(radians(GetParam()));
  double error = 0;
  for (int wall = 0; wall < kWalls; ++wall) {
    int dark = 0;
    for (int x = 0; x < kPoints; ++x) dark += lab.at(x, wall)[0] == 0 ? 1 : 0;
    error += (double(dark) / kEveryBlock - (kFirst + wall) * slope) / kWalls;
  }
  // In blocks on the floor; a texel is as long as 1 / cosine there, and the mean of eight edges off by a tenth of it.
  EXPECT_NEAR(error, 0, .25 * kTexel / std::cos(radians(GetParam())));
}

// With voxels an edge is where the block's is, and not where the texels let it be.
TEST(ShadowOfHits, ends_where_geometry_says) {
  constexpr int kWalls = 8, kPoints = 768, kFirst = 4, kEveryBlock = 32, kSun = 60;
  std::string walls;
  for (int i = 0; i < kWalls; ++i)
    walls += fmt::format(R"({}{{"box": "stone", "min": [48, 2, {}], "max": [48, {}, {}]}})", i > 0 ? ", " : "", 12 + 5 * i,
                         1 + kFirst + i, 14 + 5 * i);
  ShadowLab lab({.blocks = walls,
                 .sun = double(kSun),
                 .probe = fmt::format("vec4(lit_hit(vec3(48.0 - (float(pixel.x) + 0.5) / {}.0, 2.0, "
                                      "13.5 + 5.0 * float(pixel.y))))",
                                      kEveryBlock),
                 .functions = "#define HAS_VOXEL_READS\n"
                              "#include \"/include/gi/hit.glsl\"\n"
                              "float lit_hit(vec3 world) {\n"
                              "    vec3 position = to_volume(world - cameraPosition);\n"
                              "    ivec3 cell = ivec3(floor(position - vec3(0.0, 0.5, 0.0)));\n"
                              "    vec3 up = vec3(0.0, 1.0, 0.0);\n"
                              "    Hit hit = Hit(true, cell, position, up, voxel_at(cell), vec3(1.0), false);\n"
                              "    return sun_share(hit, light_direction(), 1.0).r;\n"
                              "}\n",
                 .options = {{"GI_METHOD", "BOUNCE_1"}, {"VOXEL_SIZE", "64"}},
                 .width = kPoints,
                 .height = kWalls});
  lab.draw();
  for (int wall = 0; wall < kWalls; ++wall) {
    int dark = 0;
    for (int x = 0; x < kPoints; ++x) dark += lab.at(x, wall)[0] == 0 ? 1 : 0;
    EXPECT_NEAR(double(dark) / kEveryBlock, (kFirst + wall) * std::tan(radians(kSun)), 1.5 / kEveryBlock) << "wall " << wall;
  }
}

// Of the hits of a path one is lit, for all: over many paths each gets its own share, and one that looks away from the sun none.
TEST(SunOfPaths, one_hit_stands_for_all_of_a_path) {
  constexpr int kSide = 64;
  ShadowLab lab({.sun = 60,
                 .probe = "vec4(shares(pixel), 1.0)",
                 .functions = "#define HAS_VOXEL_READS\n"
                              "#include \"/include/gi/sunlit.glsl\"\n"
                              "vec3 shares(ivec2 pixel) {\n"
                              "    vec3 throughput = vec3(0.9, 0.3, 2.5);\n"
                              "    vec3 up = vec3(0.0, 1.0, 0.0);\n"
                              "    Voxel none = Voxel(vec3(0.0), voxel_solid);\n"
                              "    vec3 sum = vec3(0.0);\n"
                              "    for (int path = 0; path < 16; ++path) {\n"
                              "        seed_random(pixel, path);\n"
                              "        Sunlit sunlit = no_sunlit();\n"
                              "        for (int i = 0; i < 4; ++i) {\n"
                              "            vec3 own = i < 3 ? throughput * vec3(i == 0, i == 1, i == 2) : vec3(8.0);\n"
                              "            Hit hit = Hit(true, ivec3(0), vec3(0.0), i < 3 ? up : -up, none, vec3(1.0), false);\n"
                              "            choose_sunlit(sunlit, hit, -up, own, light_direction());\n"
                              "        }\n"
                              "        sum += sunlit.sum * sunlit.throughput;\n"
                              "    }\n"
                              "    return sum / (16.0 * throughput);\n"
                              "}\n",
                 .options = {{"GI_METHOD", "FACE_CACHE"}, {"VOXEL_SIZE", "32"}},
                 .width = kSide,
                 .height = kSide});
  lab.draw();
  glm::dvec3 mean(0);
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x)
      for (int channel = 0; channel < 3; ++channel) mean[channel] += lab.at(x, y)[channel] / double(kSide * kSide);
  // A third of the paths light each: a standard deviation of .6 % over all.
  for (int channel = 0; channel < 3; ++channel) EXPECT_NEAR(mean[channel], 1, .02) << channel;
}

TEST_P(ShadowOfPoints, open_floor_has_no_acne) {
  ShadowLab floor({.sun = double(GetParam()),
                   .probe = "vec4(lit_point(vec3(20.0, 2.0, 20.0) + 0.0731 * vec3(pixel.x, 0.0, pixel.y)))",
                   .functions = kPoint,
                   .width = 64,
                   .height = 64});
  floor.draw();
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) ASSERT_EQ(floor.at(x, y)[0], 1) << x << ' ' << y;
}

// The plane of a floor, followed as far as the middle of a texel, must not come out beyond the wall. Several suns, as the
// wall's foot falls somewhere within a texel.
TEST(ShadowOfPointsIndoors, no_light_comes_in_at_the_foot_of_a_wall) {
  for (const double sun : {86., 87., 88., 88.5, 89.}) {
    ShadowLab lab({.blocks = R"({"hollow": "stone", "min": [20, 1, 20], "max": [40, 8, 44]})",
                   .sun = sun,
                   .probe = "vec4(lit_point(vec3(40.0 - (float(pixel.x) + 0.5) / 64.0, 2.0, 32.0)))",
                   .functions = kPoint});
    lab.draw();
    for (int x = 0; x < 64; ++x) EXPECT_EQ(lab.at(x)[0], 0) << sun << ' ' << x;
  }
}

INSTANTIATE_TEST_SUITE_P(, ShadowOfPoints, testing::Values(35, 60, 75));

// Row C2 of docs/failure-modes.md.
TEST(PublishedShadowBias, shows_acne_only_when_the_sun_is_low) {
  // Texels of half a block; theory says 86.5 degrees then.
  const double limit = publishedLimit(0.5);
  const auto shadowed = [](double theta) {
    ShadowLab lab({.sun = theta,
                   .probe = "vec4(lit(vec3(20.0, 2.0, 20.0) + 0.1731 * vec3(pixel.x, 0.0, pixel.y),"
                            " vec3(0.0, 1.0, 0.0)))",
                   .options = {{"SHADOW_BIAS", "PUBLISHED"}},
                   .constants = {{"SHADOW_DISTANCE", "256.0"}},
                   .width = 64,
                   .height = 64});
    lab.draw();
    int dark = 0;
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 64; ++x) dark += lab.at(x, y)[0] < 1 ? 1 : 0;
    return dark;
  };
  EXPECT_NEAR(limit, 86.5, .3);
  EXPECT_EQ(shadowed(limit - 1), 0);
  EXPECT_GT(shadowed(limit + 1), 0);
}

TEST(PublishedShadowBias, detaches_shadows_by_the_predicted_width) {
  for (const double theta : {45.0, 60.0}) {
    ShadowLab lab({.blocks = kWall,
                   .sun = theta,
                   .probe = kBehindTheWall,
                   .options = {{"SHADOW_BIAS", "PUBLISHED"}},
                   .width = 256});
    lab.draw();
    const double expected = publishedBias(theta) * kDepth * std::sin(radians(theta)) - 1;
    EXPECT_NEAR(litStrip(lab, 256), expected, 1.5 * kTexel) << theta;
  }
}

/// The light of a square of floor behind the wall.
const char* const kShadowOfWall =
    "vec4(lit(vec3(18.0, 2.0, 26.0) + 0.231 * vec3(pixel.x, 0.0, pixel.y), vec3(0.0, 1.0, 0.0)))";

int differences(const std::vector<float>& a, const std::vector<float>& b) {
  int count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) count += std::abs(a[i] - b[i]) > 0.01f ? 1 : 0;
  return count;
}

std::vector<float> pixelsOf(const ShadowLab& lab, int width, int height) {
  std::vector<float> pixels;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) pixels.push_back(lab.at(x, y)[0]);
  return pixels;
}

// Row C4 of docs/failure-modes.md.
TEST(ShadowMapStability, shadows_do_not_change_as_the_camera_turns) {
  ShadowLab lab({.blocks = kWall,
                 .sun = 60,
                 .probe = kShadowOfWall,
                 .options = {{"SHADOW_BIAS", "PUBLISHED"}},
                 .width = 64,
                 .height = 64});
  std::vector<std::vector<float>> masks;
  for (const glm::dvec3 way : {glm::dvec3(0, -1, .01), {1, 0, 0}, {-.5, .87, 0}}) {
    lab.pack().look(kShadowEye, kShadowEye + way);
    lab.draw();
    masks.push_back(pixelsOf(lab, 64, 64));
  }
  EXPECT_EQ(differences(masks[0], masks[1]), 0);
  EXPECT_EQ(differences(masks[0], masks[2]), 0);
}

// Row C5 of docs/failure-modes.md.
TEST(ShadowMapRange, what_the_map_does_not_hold_is_lit) {
  // The wall's shadow crosses the border of the map, 16 blocks from the eye.
  ShadowLab lab({.blocks = kWall,
                 .sun = 60,
                 .probe = "vec4(lit(vec3(27.0, 2.0, 8.0) + 0.5 * vec3(0.0, 0.0, pixel.x),"
                          " vec3(0.0, 1.0, 0.0)))",
                 .constants = {{"SHADOW_DISTANCE", "16.0"}},
                 .width = 96});
  lab.draw();
  for (int x = 0; x < 96; ++x) {
    const double away = std::abs(8 + 0.5 * x - kShadowEye.z);
    if (away > 14.5 && away < 17.5) continue;
    EXPECT_EQ(lab.at(x)[0], away < 16 ? 0 : 1) << x;
  }
}

TEST(ShadowMapRange, casters_before_the_near_plane_stay) {
  // The map looks from 100 blocks away, so the plane is 5 blocks over the eye.
  ShadowLab lab({.blocks = R"({"box": "stone", "min": [20, 24, 20], "max": [44, 24, 44]})",
                 .sun = 5,
                 .probe = "vec4(lit(vec3(32.0, 2.0, 32.0), vec3(0.0, 1.0, 0.0)))",
                 .change =
                     [](PackTexts& files) {
                       files["/settings.glsl"] += "\nconst float shadowNearPlane = 95.0;\n";
                     },
                 .width = 1});
  lab.draw();
  EXPECT_EQ(lab.at(0)[0], 0);
}

/// Visibilities along the sun's way over the end of the wall's shadow.
std::vector<float> edgeOf(const char* method, const char* compare) {
  ShadowLab lab({.blocks = kWall,
                 .sun = 60,
                 .probe = "vec4(lit(vec3(16.0 + float(pixel.x) / 64.0, 2.0, 32.0),"
                          " vec3(0.0, 1.0, 0.0)))",
                 .options = {{"SHADOW_METHOD", method}, {"SHADOW_COMPARE", compare}},
                 .width = 256});
  lab.draw();
  return pixelsOf(lab, 256, 1);
}

// Row C6 of docs/failure-modes.md.
TEST(ShadowFilter, nine_texels_give_four_levels_over_two_texels_at_an_even_edge) {
  const std::vector<float> edge = edgeOf("MAP_PCF", "TEXEL");
  EXPECT_EQ(std::set<int>({0, 3, 6, 9}), [&] {
    std::set<int> ninths;
    for (const float share : edge) {
      ninths.insert(int(std::lround(share * 9)));
      EXPECT_NEAR(share * 9, std::lround(share * 9), 1e-4);
    }
    return ninths;
  }());
  const auto partly =
      std::ranges::count_if(edge, [](float share) { return share > 0.01f && share < 0.99f; });
  // A texel is longer on the ground by 1 / cos(theta).
  EXPECT_NEAR(partly / 64.0, 2 * kTexel / std::cos(radians(60)), kTexel);
}

TEST(ShadowFilter, one_texel_is_lit_or_not_and_the_hardware_makes_a_ramp_of_it) {
  for (const float share : edgeOf("MAP", "TEXEL")) EXPECT_TRUE(share == 0 || share == 1);
  const std::vector<float> ramp = edgeOf("MAP", "HARDWARE");
  EXPECT_TRUE(std::ranges::is_sorted(ramp, std::greater()));
  const std::set<float> levels(ramp.begin(), ramp.end());
  EXPECT_GT(levels.size(), 8u);
}

// Row C7 of docs/failure-modes.md.
TEST(ShadowMapStability, texels_rest_in_the_world_as_the_eye_moves) {
  const auto changes = [](const char* snap) {
    ShadowLab lab({.blocks = kWall,
                   .sun = 50,
                   .probe = kShadowOfWall,
                   .options = {{"SHADOW_SNAP", snap}},
                   .width = 64,
                   .height = 64});
    std::vector<std::vector<float>> masks;
    // The host moves the map by whole intervals of 2 blocks.
    for (const double way : {0.0, 0.3 * kTexel, 2.3}) {
      lab.pack().look(kShadowEye + glm::dvec3(way, 0, 0), kShadowEye + glm::dvec3(way, -1, .01));
      lab.draw();
      masks.push_back(pixelsOf(lab, 64, 64));
    }
    return std::pair(differences(masks[0], masks[1]), differences(masks[0], masks[2]));
  };
  const auto [little, far] = changes("true");
  EXPECT_EQ(little, 0);
  EXPECT_LE(far, 4);  // .1 %
  EXPECT_GT(changes("false").second, 40);
}

TEST(ShadowMapStability, a_distorted_map_is_finer_near_the_eye) {
  // Seen on both sides of the end of a shadow near the eye: the ramp of three texels.
  const auto width = [](const char* distortion) {
    ShadowLab lab({.blocks = R"({"box": "stone", "min": [34, 2, 8], "max": [34, 3, 55]})",
                   .sun = 60,
                   .probe = "vec4(lit(vec3(28.0 + float(pixel.x) / 64.0, 2.0, 32.0),"
                            " vec3(0.0, 1.0, 0.0)))",
                   .options = {{"SHADOW_DISTORTION", distortion}},
                   .width = 256});
    lab.draw();
    const std::vector<float> edge = pixelsOf(lab, 256, 1);
    return std::ranges::count_if(edge, [](float share) { return share > 0 && share < 1; });
  };
  const auto even = width("0.0"), fine = width("0.85");
  EXPECT_GT(even, 0);
  EXPECT_LT(fine * 3, even);
}

}  // namespace
}  // namespace orris::test
