// The face cache against closed forms, and how it follows changes.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "face_boiling.h"
#include "face_field.h"

namespace orris::test {
namespace {

OptionValues cacheOptions(OptionValues more = {}) {
  more.insert({{"GI_METHOD", "FACE_CACHE"}, {"VOXEL_SIZE", std::to_string(kFaceVolume)}});
  return more;
}

/// A closed room of `wall` blocks at night with a lamp in the middle of its ceiling.
std::string room(const std::string& wall, glm::ivec3 inside, const std::string& events = "") {
  const glm::ivec3 end = inside + 1;
  return fmt::format(
      R"({{"size": [{0}, {1}, {2}],
      "blocks": [{{"hollow": "{3}", "min": [0, 0, 0], "max": [{4}, {5}, {6}]}},
                 {{"block": "glowstone", "at": [{7}, {5}, {8}]}}],
      "cameras": [{{"name": "eye", "position": [{7}.5, 1.5, {8}.5]}}],
      "environment": {{"time": 18000}}, "events": [{9}]}})",
      end.x + 1, end.y + 1, end.z + 1, wall, end.x, end.y, end.z, (end.x) / 2, (end.z) / 2, events);
}

constexpr double kGlowstone = 16;  // its radiance, red: EMISSION_STRENGTH

/// Mean albedo of blocks as the voxels have it, red: that of one block is up to a step of a byte off.
double albedo(PackSession& pack, const std::vector<glm::ivec3>& blocks, glm::ivec3 eye) {
  const auto voxels = pack.voxels({.volume = kFaceVolume, .columns = 32});
  double sum = 0;
  for (const glm::ivec3& block : blocks) {
    const double stored = voxels.red(cellOf(block, eye, kFaceVolume));
    sum += stored * stored / double(blocks.size());
  }
  return sum;
}

/// Share of the light of one unit square that reaches another, parallel and right opposite.
double oppositeSquares(double distance) {
  const double x = 1 / distance, s = std::sqrt(1 + x * x);
  return 2 / (std::numbers::pi * x * x) *
         (std::log(s * s / std::sqrt(1 + 2 * x * x)) + 2 * x * s * std::atan(x / s) -
          2 * x * std::atan(x));
}

/// 49 shafts of this height, one block wide, under a lamp each; the eye is in the middle one.
std::string shafts(const std::string& wall, int height) {
  std::string world = fmt::format(
      R"({{"size": [15, {0}, 15],
      "blocks": [{{"box": "{1}", "min": [0, 0, 0], "max": [14, {2}, 14]}})",
      height + 2, wall, height + 1);
  for (int i = 0; i < 49; ++i) {
    const int x = 1 + i % 7 * 2, z = 1 + i / 7 * 2;
    world += fmt::format(R"(,
      {{"box": "air", "min": [{0}, 1, {1}], "max": [{0}, {2}, {1}]}},
      {{"block": "glowstone", "at": [{0}, {3}, {1}]}})",
                         x, z, height, height + 1);
  }
  return world + R"(],
      "cameras": [{"name": "eye", "position": [7.5, 1.5, 7.5]}],
      "environment": {"time": 18000}})";
}

/// Mean red of the floors of all shafts, offset to another face; over `frames` frames.
double meanOfShafts(const FaceField& field, glm::ivec3 offset, Face face) {
  double sum = 0;
  for (int i = 0; i < 49; ++i)
    sum += field.red(glm::ivec3(1 + i % 7 * 2, 0, 1 + i / 7 * 2) + offset, face);
  return sum / 49;
}

// Six faces see each other, one of them a lamp, which reflects light as well: a system of three unknowns by symmetry.
TEST(FaceCache, one_cell_room_is_the_radiosity_solution) {
  PackSession pack(shafts("white_concrete", 1),
                   cacheOptions({{"FACE_SHARE", "1"}, {"FACE_WINDOW", "128"}}), 8, 8);
  pack.renderFrames(200);
  std::vector<glm::ivec3> floors, lamps;
  for (int i = 0; i < 49; ++i) {
    floors.emplace_back(1 + i % 7 * 2, 0, 1 + i / 7 * 2);
    lamps.push_back(floors.back() + glm::ivec3(0, 2, 0));
  }
  const double rho = albedo(pack, floors, {7, 1, 7}), lampRho = albedo(pack, lamps, {7, 1, 7});
  const double opposite = oppositeSquares(1), beside = (1 - opposite) / 4;
  double floor = 0, wall = 0, lamp = 0;
  for (int i = 0; i < 200; ++i) {
    const double shines = kGlowstone + lampRho * lamp;
    lamp = opposite * rho * floor + 4 * beside * rho * wall;
    floor = opposite * shines + 4 * beside * rho * wall;
    wall = beside * shines + beside * rho * floor + (opposite + 2 * beside) * rho * wall;
  }
  EXPECT_GT(lampRho, 0.2);
  double floorMean = 0, wallMean = 0;
  for (int i = 0; i < 3; ++i) {
    pack.renderFrames(60);
    const FaceField field = faceField(pack, kFaceVolume);
    floorMean += meanOfShafts(field, {0, 0, 0}, kUp) / 3;
    wallMean += (meanOfShafts(field, {-1, 1, 0}, kEast) + meanOfShafts(field, {1, 1, 0}, kWest) +
                 meanOfShafts(field, {0, 1, -1}, kSouth) + meanOfShafts(field, {0, 1, 1}, kNorth)) /
                4 / 3;
  }
  RecordProperty("relative", fmt::format("{:.4f} {:.4f}", floorMean / floor, wallMean / wall));
  EXPECT_GT(rho, 0.5);
  EXPECT_NEAR(floorMean / floor, 1, .01);
  EXPECT_NEAR(wallMean / wall, 1, .01);
}

/// Share of the light of unit squares that reach each other across a gap: the lower at the origin,
/// the upper moved by `x` and `z`. Midpoint rule.
double squaresAcross(double gap, int x, int z) {
  constexpr int kSteps = 8;
  double sum = 0;
  for (int i = 0; i < kSteps * kSteps * kSteps * kSteps; ++i) {
    const double dx = x + (i % kSteps - i / kSteps % kSteps) / double(kSteps);
    const double dz = z + (i / 64 % kSteps - i / 512) / double(kSteps);
    const double squared = dx * dx + dz * dz + gap * gap;
    sum += gap * gap / (std::numbers::pi * squared * squared);
  }
  return sum / (kSteps * kSteps * kSteps * kSteps);
}

// Near lamps are found by rays, far ones sampled: no light is counted twice or lost between.
TEST(FaceCache, lamps_at_any_distance_give_their_form_factor) {
  for (const int height : {1, 2, 5}) {
    std::string world = fmt::format(
        R"({{"size": [13, {0}, 13], "cameras": [{{"name": "eye", "position": [6.5, 1.5, 6.5]}}],
        "environment": {{"time": 18000}},
        "blocks": [{{"hollow": "black_concrete", "min": [0, 0, 0], "max": [12, {1}, 12]}})",
        height + 2, height + 1);
    for (int i = 0; i < 9; ++i)
      world += fmt::format(R"(, {{"block": "glowstone", "at": [{}, {}, {}]}})", 4 + i % 3 * 2,
                           height + 1, 4 + i / 3 * 2);
    PackSession pack(
        world + "]}",
        cacheOptions({{"FACE_SHARE", "1"}, {"FACE_WINDOW", "128"}, {"FACE_GAIN", "1.0"}}));
    pack.renderFrames(400);
    double expected = 0;
    for (int i = 0; i < 9 * 81; ++i)
      expected +=
          kGlowstone / 81 *
          squaresAcross(height, 4 + i % 3 * 2 - (2 + i / 9 % 9), 4 + i / 3 % 3 * 2 - (2 + i / 81));
    const double mean = faceField(pack, kFaceVolume).meanRed({2, 0, 2}, {10, 0, 10}, kUp);
    EXPECT_NEAR(mean / expected, 1, .015) << height;
  }
}

/// Mean radiance that a floor gets of a sphere half a block above its middle, over what a square in the middle leaves of it, for
/// radiance 1. `half`: of the square's edge.
double floorBelowSphere(double radius, double half) {
  constexpr int kSteps = 400;
  double sum = 0;
  int counted = 0;
  for (int i = 0; i < kSteps * kSteps; ++i) {
    const double x = (i % kSteps + .5) / kSteps - .5, z = (i / kSteps + .5) / kSteps - .5;
    if (std::max(std::abs(x), std::abs(z)) < half) continue;
    ++counted;
    sum += radius * radius * .5 / std::pow(.25 + x * x + z * z, 1.5);
  }
  return sum / counted;
}

// A lantern hides what of the floor gets most of its light.
TEST(FaceCache, floor_below_a_lantern_has_the_light_of_what_it_leaves_free) {
  PackSession pack(R"({"size": [7, 7, 7],
      "blocks": [{"hollow": "black_concrete", "min": [0, 0, 0], "max": [6, 6, 6]}, {"block": "lantern", "at": [3, 1, 3]}],
      "cameras": [{"name": "eye", "position": [1.5, 1.5, 1.5]}], "environment": {"time": 18000}})",
                   cacheOptions({{"FACE_SHARE", "1"}, {"FACE_WINDOW", "128"}, {"FACE_RAYS", "16"}}), 8, 8);
  const double expected = 5 * kGlowstone * floorBelowSphere(.25, 3. / 16);
  double sum = 0;  // of means whose windows hardly overlap: one has a standard deviation of 1.5 %
  for (int i = 0; i < 4; ++i) {
    pack.renderFrames(200);
    sum += faceField(pack, kFaceVolume).red({3, 0, 3}, kUp) / expected;
  }
  EXPECT_NEAR(sum / 4, 1, .02);
}

TEST(FaceCache, removed_lamp_fades_and_a_placed_one_fills_the_room) {
  PackSession pack(room("white_concrete", {12, 12, 12},
                        R"({"frame": 80, "set": {"at": [6, 13, 6], "block": "white_concrete"}},
                           {"frame": 200, "set": {"at": [6, 13, 6], "block": "glowstone"}})"),
                   cacheOptions(), 8, 8);
  const auto floor = [&pack] {
    return faceField(pack, kFaceVolume).meanRed({1, 0, 1}, {12, 0, 12}, kUp);
  };
  pack.renderFrames(80);
  const double lit = floor();
  int fading = 0;
  for (double now = lit; now > 0.01 * lit && fading < 200; ++fading) {
    pack.renderFrames(1);
    now = floor();
  }
  EXPECT_LE(fading, 50);
  pack.renderFrames(120 - fading);
  EXPECT_LT(floor(), 0.005 * lit);
  pack.renderFrames(2);
  EXPECT_GT(floor(), 0.2 * lit) << "the frame after";
  int filling = 2;
  for (; floor() < 0.9 * lit && filling < 200; ++filling) pack.renderFrames(1);
  EXPECT_LE(filling, 30);
}

// The picture, with the default means over frames.
TEST(FaceCache, picture_follows_a_removed_lamp) {
  const std::string event = R"({"frame": 130, "set": {"at": [6, 13, 6], "block": "air"}})";
  PackSession pack(room("light_gray_concrete", {12, 12, 12}, event),
                   cacheOptions({{"AMBIENT_MINIMUM", "0.0"}}));
  pack.renderFrames(130);
  const double lit = pack.meanRadiance().r;
  pack.renderFrames(60);
  EXPECT_LT(pack.meanRadiance().r, 0.01 * lit);
}

TEST(FaceCache, closed_wall_lets_nothing_through) {
  const char* const world = R"({
    "size": [13, 8, 8],
    "blocks": [{"hollow": "white_concrete", "min": [0, 0, 0], "max": [12, 7, 7]},
               {"box": "white_concrete", "min": [6, 0, 0], "max": [6, 7, 7]},
               {"block": "glowstone", "at": [3, 7, 3]}],
    "cameras": [{"name": "eye", "position": [9.5, 3.5, 3.5]}],
    "environment": {"time": 18000}
  })";
  PackSession pack(world, cacheOptions());
  pack.renderFrames(60);
  const FaceField field = faceField(pack, kFaceVolume);
  EXPECT_GT(field.meanRed({6, 1, 1}, {6, 6, 6}, kWest), 0.1);
  EXPECT_EQ(field.meanRed({6, 1, 1}, {6, 6, 6}, kEast), 0);
  EXPECT_EQ(field.meanRed({7, 0, 1}, {11, 0, 6}, kUp), 0);
  EXPECT_GT(field.updates({9, 0, 3}, kUp), 10);
}

// The picture of the dark one of two rooms: black, while the one beside it is lit.
TEST(FaceCache, picture_of_a_dark_room_behind_a_wall_is_black) {
  const OptionValues plain = cacheOptions({{"AMBIENT_MINIMUM", "0.0"}, {"VOXEL_SIZE", "64"}});
  PackSession pack = PackSession::ofWorld("h5_two_rooms", plain, 32, 18);
  pack.renderFrames(20);
  EXPECT_GT(pack.meanRadiance().r, .05) << "the lit room";
  pack.look({25.5, 5, 11.5}, {16, 5, 3});
  pack.renderFrames(20);
  EXPECT_EQ(pack.meanRadiance(), glm::dvec3(0));
}

// Two rooms with a wall between them, and a lamp in one.
TEST(FaceCache, opened_wall_lights_the_dark_room) {
  const char* const world = R"({
    "size": [27, 14, 14],
    "blocks": [{"hollow": "light_gray_concrete", "min": [0, 0, 0], "max": [26, 13, 13]},
               {"box": "light_gray_concrete", "min": [13, 0, 0], "max": [13, 13, 13]},
               {"block": "glowstone", "at": [6, 13, 6]}],
    "cameras": [{"name": "eye", "position": [15.5, 6.5, 6.5]}],
    "environment": {"time": 18000},
    "events": [{"frame": 280, "set": {"at": [13, 6, 6], "block": "air"}},
               {"frame": 280, "set": {"at": [13, 6, 7], "block": "air"}},
               {"frame": 280, "set": {"at": [13, 7, 6], "block": "air"}},
               {"frame": 280, "set": {"at": [13, 7, 7], "block": "air"}}]
  })";
  PackSession pack(world, cacheOptions({{"FACE_SHARE", "1"}}), 8, 8);
  const auto floor = [&pack] {
    return faceField(pack, kFaceVolume).meanRed({14, 0, 1}, {25, 0, 12}, kUp);
  };
  pack.renderFrames(280);
  EXPECT_EQ(floor(), 0);
  std::array<double, 61> after{};
  for (double& light : after) {
    pack.renderFrames(1);
    light = floor();
  }
  pack.renderFrames(120);
  const double settled = floor();
  const auto filled = std::find_if(after.begin(), after.end(),
                                   [settled](double light) { return light > 0.9 * settled; });
  EXPECT_LE(filled - after.begin(), 40);
  EXPECT_GT(after[1], 0.1 * settled) << "first light";
}

// Two rooms one volume apart have the same texels; what is floor here is buried there.
const char* const kTwoRooms = R"({
  "size": [42, 10, 10],
  "blocks": [{"hollow": "white_concrete", "min": [0, 0, 0], "max": [9, 9, 9]},
             {"hollow": "white_concrete", "min": [32, 0, 0], "max": [41, 9, 9]},
             {"box": "white_concrete", "min": [32, 0, 0], "max": [41, 2, 9]},
             {"block": "quartz_slab[type=bottom]", "at": [2, 1, 2]},
             {"block": "glowstone", "at": [4, 9, 4]}],
  "cameras": [{"name": "eye", "position": [4.5, 4.5, 4.5]}],
  "environment": {"time": 18000, "skyColor": [0, 0, 0]},
  "events": [{"frame": 40, "camera": {"position": [36.5, 4.5, 4.5]}}]
})";

TEST(FaceCache, teleport_leaves_no_old_light) {
  PackSession pack(kTwoRooms, cacheOptions({{"SKY_STRENGTH", "0.0"}, {"SUN_STRENGTH", "2.0"}}));
  pack.renderFrames(40);
  EXPECT_GT(faceField(pack, kFaceVolume).meanRed({1, 0, 1}, {8, 0, 8}, kUp), 0.1);
  pack.renderFrames(1);
  const FaceField field = faceField(pack, kFaceVolume);
  EXPECT_EQ(field.meanRed({33, 2, 1}, {40, 2, 8}, kUp), 0);
  EXPECT_EQ(field.updates({36, 2, 4}, kUp), 1) << "new faces are all updated";
  EXPECT_LT(field.brightest(), 0.01f) << "buried faces too; outside is the moon";
  EXPECT_LT(lastEdit(pack), 5) << "moving is no edit";
}

TEST(FaceCache, faces_keep_their_light_while_the_volume_moves) {
  // A hall along x; the eye walks a block a frame, through 0.
  std::string events;
  for (int i = 0; i < 12; ++i)
    events += fmt::format(R"({}{{"frame": {}, "camera": {{"position": [{}.5, 3.5, 4.5]}}}})",
                          i > 0 ? "," : "", 60 + i, i - 5);
  const std::string world = fmt::format(R"({{
    "origin": [-12, 0, 0], "size": [24, 8, 9],
    "blocks": [{{"hollow": "white_concrete", "min": [-12, 0, 0], "max": [11, 7, 8]}},
               {{"block": "glowstone", "at": [0, 7, 4]}}],
    "cameras": [{{"name": "eye", "position": [-6.5, 3.5, 4.5]}}],
    "environment": {{"time": 18000}}, "events": [{}]}})",
                                        events);
  // 48 does not divide 2^32, so that a remainder of negative cells must be right.
  constexpr int kOdd = 48;
  PackSession pack(world,
                   cacheOptions({{"FACE_SHARE", "1"}, {"VOXEL_SIZE", std::to_string(kOdd)}}));
  pack.renderFrames(60);
  const FaceField before = faceField(pack, kOdd);
  pack.renderFrames(12);
  const FaceField after = faceField(pack, kOdd);
  const glm::ivec3 low(-9, 0, 1), high(8, 0, 7);
  EXPECT_NEAR(
      before.meanRed({-6, 0, 1}, {-1, 0, 7}, kUp) / before.meanRed({1, 0, 1}, {6, 0, 7}, kUp), 1,
      .1)
      << "both sides of the lamp, and of 0";
  EXPECT_NEAR(after.meanRed(low, high, kUp) / before.meanRed(low, high, kUp), 1, .05);
  EXPECT_EQ(after.updates({0, 0, 4}, kUp), before.updates({0, 0, 4}, kUp) + 12);
  EXPECT_LT(lastEdit(pack), 5);
}

TEST(FaceCache, edits_are_noticed_while_the_volume_moves) {
  const char* const world = R"({
    "size": [16, 8, 8],
    "blocks": [{"hollow": "white_concrete", "min": [0, 0, 0], "max": [15, 7, 7]}],
    "cameras": [{"name": "eye", "position": [6.5, 3.5, 3.5]}],
    "environment": {"time": 18000},
    "events": [{"frame": 20, "camera": {"position": [7.5, 3.5, 3.5]}},
               {"frame": 20, "set": {"at": [6, 1, 3], "block": "red_concrete"}},
               {"frame": 30, "set": {"at": [6, 1, 3], "block": "lime_concrete"}}]
  })";
  PackSession pack(world, cacheOptions());
  pack.renderFrames(20);
  const int before = lastEdit(pack);
  pack.renderFrames(1);
  const int first = lastEdit(pack);
  pack.renderFrames(9);
  EXPECT_EQ(lastEdit(pack), first);
  pack.renderFrames(1);
  EXPECT_LT(before, first);
  EXPECT_EQ(lastEdit(pack), first + 10) << "another block of the same shape";
}

TEST(FaceCache, only_a_share_of_the_faces_is_updated_while_nothing_changes) {
  const std::string event = R"({"frame": 70, "set": {"at": [2, 1, 2], "block": "oak_stairs"}})";
  PackSession pack(room("white_concrete", {6, 6, 6}, event), cacheOptions({{"FACE_SHARE", "4"}}));
  pack.renderFrames(30);
  const int all = updatedFaces(pack);
  EXPECT_EQ(all, 6 * 6 * 6 + 6 * 8 * 8) << "both sides of the walls, and of the lamp";
  pack.renderFrames(30);
  int sum = 0;
  for (int i = 0; i < 4; ++i, sum += updatedFaces(pack)) pack.renderFrames(1);
  EXPECT_EQ(sum, all) << "each once in four frames";
  pack.renderFrames(8);
  EXPECT_EQ(updatedFaces(pack), all + 6)
      << "after the edit: five sides, whatever their quads, tread, riser, and one hidden";
  pack.renderFrames(60);
  EXPECT_LT(updatedFaces(pack), all / 3);
}

TEST(FaceCache, half_of_the_faces_are_updated_while_edits_follow_each_other) {
  std::string events;
  for (int frame = 70; frame < 100; frame += 2)
    events += fmt::format(R"({}{{"frame": {}, "set": {{"at": [2, 1, 2], "block": "{}"}}}})", frame > 70 ? "," : "", frame,
                          frame % 4 == 0 ? "stone" : "air");
  PackSession pack(room("white_concrete", {6, 6, 6}, events), cacheOptions({{"FACE_SHARE", "4"}}));
  pack.renderFrames(58);
  int all = 0;
  for (int i = 0; i < 4; ++i, all += updatedFaces(pack)) pack.renderFrames(1);
  pack.renderFrames(20);
  for (int i = 0; i < 2; ++i) {
    int both = 0;
    for (int frame = 0; frame < 2; ++frame, both += updatedFaces(pack)) pack.renderFrames(1);
    EXPECT_NEAR(both, all, 8) << "each once in two frames, and the block that comes and goes";
  }
}

// Boiling. FACE_GAIN=1 only shortens the time until a face rests on a whole window.
/// A room with nine lamps, at rest.
struct Settled {
  FaceBoiling boiling{{0, 0, 0}, {14, 8, 14}};
  double floor = 0;  // mean red
};

Settled settledRoom(const std::string& rays) {
  std::string world = R"({"size": [14, 8, 14],
      "cameras": [{"name": "eye", "position": [6.5, 3.5, 6.5]}], "environment": {"time": 18000},
      "blocks": [{"hollow": "light_gray_concrete", "min": [0, 0, 0], "max": [13, 7, 13]})";
  for (int i = 0; i < 9; ++i)
    world += fmt::format(R"(, {{"block": "glowstone", "at": [{}, {}, {}]}})", 3 + i % 3 * 3,
                         2 + i % 2 * 3, 3 + i / 3 * 3);
  PackSession pack(
      world + "]}",
      cacheOptions({{"FACE_SHARE", "1"}, {"FACE_GAIN", "1.0"}, {"FACE_RAYS", rays}}), 8, 8);
  Settled settled;
  pack.renderFrames(150);
  for (int i = 0; i < 24; ++i) {
    pack.renderFrames(8);
    const FaceField field = faceField(pack, kFaceVolume);
    settled.boiling.add(field);
    settled.floor += field.meanRed({1, 0, 1}, {12, 0, 12}, kUp) / 24;
  }
  return settled;
}

TEST(FaceCache, settled_light_hardly_changes_and_half_as_much_by_four_rays_a_face) {
  const Settled one = settledRoom("1"), four = settledRoom("4");
  const double boiling = one.boiling.ofFaces();
  RecordProperty("boiling", fmt::format("{:.4f}", boiling));
  EXPECT_EQ(one.boiling.faces(), 12 * 12 * 2 + 12 * 6 * 4 + 9 * 6) << "walls and lamps";
  EXPECT_LT(boiling, .05);
  EXPECT_GT(boiling, .01) << "nothing is sampled";
  EXPECT_NEAR(four.boiling.ofFaces() / boiling, .5, .05);
  EXPECT_NEAR(four.floor / one.floor, 1, .01);
}

}  // namespace
}  // namespace orris::test
