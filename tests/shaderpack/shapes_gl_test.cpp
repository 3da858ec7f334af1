// Rays and the face cache on blocks that fill a part of their cell: stairs, slabs, doors,
// fences, walls, chests.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "face_field.h"

namespace orris::test {
namespace {

constexpr int kVolume = 32;
constexpr double kLamp = 16;  // radiance of glowstone, red: EMISSION_STRENGTH

OptionValues options() {
  return {{"GI_METHOD", "FACE_CACHE"},
          {"VOXEL_SIZE", std::to_string(kVolume)},
          {"FACE_SHARE", "1"},
          {"FACE_GAIN", "1.0"}};
}

/// 49 holes in a dark block with this block in them, under a lamp each: next to it or a block above.
std::string cells(const std::string& block, int lamp) {
  std::string world = R"({"size": [15, 5, 15],
      "cameras": [{"name": "eye", "position": [7.5, 2.5, 7.5]}], "environment": {"time": 18000},
      "blocks": [{"box": "black_concrete", "min": [0, 0, 0], "max": [14, 4, 14]})";
  for (int i = 0; i < 49; ++i)
    world += fmt::format(R"(, {{"block": "air", "at": [{1}, 2, {2}]}},
        {{"block": "{0}", "at": [{1}, 1, {2}]}}, {{"block": "glowstone", "at": [{1}, {3}, {2}]}})",
                         block, 1 + i % 7 * 2, 1 + i / 7 * 2, lamp);
  return world + "]}";
}

double meanOfCells(const FaceField& field, int y, Face face) {
  double sum = 0;
  for (int i = 0; i < 49; ++i) sum += field.red({1 + i % 7 * 2, y, 1 + i / 7 * 2}, face) / 49;
  return sum;
}

/// Form factors in closed form: of equal rectangles x by y right opposite at distance 1, and of two of
/// length 1 at a right angle that share it, of width w and h, from the one of width w.
double oppositeRectangles(double x, double y) {
  const double xx = 1 + x * x, yy = 1 + y * y;
  return 2 / (std::numbers::pi * x * y) *
         (std::log(std::sqrt(xx * yy / (xx + yy - 1))) +
          x * std::sqrt(yy) * std::atan(x / std::sqrt(yy)) +
          y * std::sqrt(xx) * std::atan(y / std::sqrt(xx)) - x * std::atan(x) - y * std::atan(y));
}

double cornerRectangles(double w, double h) {
  const double ww = w * w, hh = h * h, all = 1 + ww + hh, diagonal = std::sqrt(ww + hh);
  const double logarithms = std::log((1 + ww) * (1 + hh) / all) +
                            ww * std::log(ww * all / ((1 + ww) * (ww + hh))) +
                            hh * std::log(hh * all / ((1 + hh) * (ww + hh)));
  return 1 / (std::numbers::pi * w) *
         (w * std::atan(1 / w) + h * std::atan(1 / h) - diagonal * std::atan(1 / diagonal) +
          logarithms / 4);
}

// The upper half of the stairs takes the lamp's other half from the tread; and of the faces towards the
// step, those on the side of the cell are behind the wall.
TEST(LightOfShapes, tread_and_riser_see_half_of_the_lamp_over_them) {
  PackSession pack(cells("nether_brick_stairs[facing=north]", 2), options());
  pack.renderFrames(140);
  const FaceField field = faceField(pack, kVolume);
  EXPECT_NEAR(meanOfCells(field, 1, kInnerY) / (kLamp * oppositeRectangles(2, 1)), 1, .04);
  EXPECT_NEAR(meanOfCells(field, 1, kInnerZ) / (kLamp * cornerRectangles(.5, .5)), 1, .04);
}

// Either half of a square sees as much of an equal one opposite.
TEST(LightOfShapes, step_and_tread_of_a_stair_have_their_own_light) {
  PackSession pack(cells("nether_brick_stairs[facing=north]", 3), options());
  pack.renderFrames(140);
  const FaceField field = faceField(pack, kVolume);
  EXPECT_NEAR(meanOfCells(field, 1, kUp) / (kLamp * oppositeRectangles(1, 1)), 1, .04);
  EXPECT_LT(meanOfCells(field, 1, kInnerY), .6 * meanOfCells(field, 1, kUp));
}

TEST(LightOfShapes, wall_beside_a_slab_has_the_light_of_its_open_half) {
  PackSession pack(cells("nether_brick_slab[type=bottom]", 2), options());
  pack.renderFrames(140);
  const FaceField field = faceField(pack, kVolume);
  double sum = 0;
  for (int i = 0; i < 49; ++i) sum += field.red({i % 7 * 2, 1, 1 + i / 7 * 2}, kEast) / 49;
  EXPECT_NEAR(sum / (kLamp * cornerRectangles(.5, 1)), 1, .04);
}

/// Light on a ceiling that hardly anything but this floor lights.
double ceilingOver(const std::string& floor) {
  PackSession pack(fmt::format(R"({{"size": [9, 5, 9],
      "cameras": [{{"name": "eye", "position": [4.5, 2.5, 4.5]}}], "environment": {{"time": 18000}},
      "blocks": [{{"hollow": "black_concrete", "min": [0, 0, 0], "max": [8, 4, 8]}},
                 {{"box": "{}", "min": [1, 1, 1], "max": [7, 1, 7]}},
                 {{"block": "glowstone", "at": [4, 4, 4]}}]}})",
                               floor),
                   options());
  pack.renderFrames(40);
  return faceField(pack, kVolume).meanRed({1, 4, 1}, {7, 4, 7}, kDown);
}

TEST(LightOfShapes, rays_find_the_light_on_the_top_of_slabs) {
  const double slabs = ceilingOver("smooth_quartz_slab[type=bottom]");
  EXPECT_GT(slabs, .5 * ceilingOver("smooth_quartz"));
  EXPECT_GT(slabs, 5 * ceilingOver("black_concrete"));
}

TEST(LightOfShapes, slab_shades_the_floor_of_its_cell) {
  PackSession pack(cells("stone_slab[type=top]", 3), options());
  pack.renderFrames(20);
  const FaceField field = faceField(pack, kVolume);
  EXPECT_EQ(meanOfCells(field, 0, kUp), 0);
  EXPECT_GT(field.updates({7, 0, 7}, kUp), 10);
}

// The floor below a lamp, with more and more between them.
TEST(LightOfShapes, posts_and_arms_shade_the_floor) {
  const auto floor = [](const std::string& block) {
    PackSession pack(cells(block, 2), options());
    pack.renderFrames(60);
    return meanOfCells(faceField(pack, kVolume), 0, kUp);
  };
  const double open = floor("air");
  EXPECT_NEAR(open / (kLamp * oppositeRectangles(1, 1)), 1, .04);
  const double post = floor("oak_fence"), rails = floor("oak_fence[east=true,west=true]"),
               wall = floor("stone_brick_wall"),
               cross = floor("stone_brick_wall[north=low,south=low,east=low,west=low]");
  EXPECT_LT(post, .95 * open);
  EXPECT_LT(rails, .95 * post);
  EXPECT_LT(wall, .9 * post);
  EXPECT_LT(cross, .7 * wall);
}

// A strip half a block wide from the lamp's edge inwards, so less than half of the corner of a whole one.
TEST(LightOfShapes, posts_are_lit_on_their_own_sides) {
  PackSession pack(cells("stone_brick_wall", 2), options());
  pack.renderFrames(60);
  const FaceField field = faceField(pack, kVolume);
  const double side = meanOfCells(field, 1, kEast);
  EXPECT_GT(side, .4 * kLamp * cornerRectangles(1, 1));
  EXPECT_LT(side, .6 * kLamp * cornerRectangles(1, 1));
  EXPECT_NEAR(meanOfCells(field, 1, kSouth) / side, 1, .1);
}

// The top is two sixteenths below the cell's, and smaller than the lamp a block above it.
TEST(LightOfShapes, chests_are_lit_on_their_tops) {
  PackSession pack(cells("chest", 3), options());
  pack.renderFrames(140);
  const double top = meanOfCells(faceField(pack, kVolume), 1, kUp);
  const double asLarge = kLamp * oppositeRectangles(1 / 1.125, 1 / 1.125);
  EXPECT_GT(top, asLarge);
  EXPECT_LT(top, 1.1 * asLarge);
}

TEST(LightOfShapes, chests_shade_the_wall_beside_them) {
  const auto wall = [](const std::string& block) {
    PackSession pack(cells(block, 2), options());
    pack.renderFrames(60);
    const FaceField field = faceField(pack, kVolume);
    double sum = 0;
    for (int i = 0; i < 49; ++i) sum += field.red({i % 7 * 2, 1, 1 + i / 7 * 2}, kEast);
    return sum;
  };
  EXPECT_LT(wall("chest"), .7 * wall("air"));
}

// A window that two chests fill lets light pass between them, one that a large chest fills does not.
TEST(LightOfShapes, halves_of_a_chest_leave_no_gap) {
  const auto beyond = [](const std::string& left, const std::string& right) {
    PackSession pack(fmt::format(R"({{"size": [8, 5, 7],
        "cameras": [{{"name": "eye", "position": [3.5, 2.5, 5.5]}}], "environment": {{"time": 18000}},
        "blocks": [{{"hollow": "black_concrete", "min": [0, 0, 0], "max": [7, 4, 6]}},
                   {{"box": "black_concrete", "min": [0, 0, 3], "max": [7, 4, 3]}},
                   {{"block": "chest[facing=north,{}]", "at": [3, 2, 3]}},
                   {{"block": "chest[facing=north,{}]", "at": [4, 2, 3]}},
                   {{"box": "glowstone", "min": [3, 2, 1], "max": [4, 2, 1]}}]}})",
                                 left, right),
                     options());
    pack.renderFrames(300);
    return faceField(pack, kVolume).meanRed({1, 1, 6}, {6, 3, 6}, kNorth);
  };
  EXPECT_LT(beyond("type=left", "type=right"), .85 * beyond("type=single", "type=single"));
}

// A quarter of an oak trapdoor is open, a square in each of its quarters. What of the lamp the floor sees
// through them, of all that it sees without: (1/r^4 over the rays that pass) by integration.
TEST(LightOfShapes, light_passes_the_holes_of_trapdoors) {
  const auto floor = [](const std::string& block) {
    PackSession pack(cells(block, 2), options());
    pack.renderFrames(140);
    return meanOfCells(faceField(pack, kVolume), 0, kUp);
  };
  EXPECT_NEAR(floor("oak_trapdoor[half=top]") / floor("air"), .322, .015);
}

TEST(LightOfShapes, shut_doors_let_nothing_through) {
  PackSession pack(R"({"size": [13, 6, 7],
      "cameras": [{"name": "eye", "position": [9.5, 2.5, 3.5]}], "environment": {"time": 18000},
      "blocks": [{"hollow": "white_concrete", "min": [0, 0, 0], "max": [12, 5, 6]},
                 {"box": "white_concrete", "min": [6, 0, 0], "max": [6, 5, 6]},
                 {"block": "oak_door[half=lower,facing=east]", "at": [6, 1, 3]},
                 {"block": "oak_door[half=lower,facing=east]", "at": [6, 2, 3]},
                 {"block": "glowstone", "at": [3, 5, 3]}]})",
                   options());
  pack.renderFrames(40);
  const FaceField field = faceField(pack, kVolume);
  EXPECT_GT(field.meanRed({1, 0, 1}, {5, 0, 5}, kUp), .1);
  EXPECT_EQ(field.meanRed({7, 0, 1}, {11, 0, 5}, kUp), 0);
}

}  // namespace
}  // namespace orris::test
