// Where light goes within the volume: to six neighbours, never through a wall or over its edge, and
// along with the camera.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include "lab.h"
#include "linear_field.h"

namespace orris::test {
namespace {

const AtlasLayout kLayout{kLabSize, kLabSize};
const glm::ivec3 kAway[6] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};

// Row A13 of docs/failure-modes.md.
TEST(FloodfillSteps, one_step_lights_exactly_the_six_neighbours) {
  Lab lab({.blocks = R"({"block": "glowstone", "at": [12, 14, 18]})"});
  lab.step();
  const CellField light = lab.light();
  const glm::ivec3 lamp(12, 14, 18);
  EXPECT_EQ(light.countLit(), 7) << "and the lamp";
  const float first = light.red(lamp + kAway[0]);
  EXPECT_NEAR(first / light.red(lamp), 2.43902 / 6, 2e-4);
  for (const glm::ivec3 away : kAway) EXPECT_EQ(light.red(lamp + away), first);
}

TEST(FloodfillSteps, light_of_a_lamp_is_symmetric_to_the_last_bit) {
  Lab lab({.blocks = R"({"block": "glowstone", "at": [16, 16, 16]})"});
  lab.step(9);
  const CellField light = lab.light();
  int different = 0;
  for (int z = 1; z < kLabSize; ++z)
    for (int y = 1; y < kLabSize; ++y)
      for (int x = 1; x < kLabSize; ++x) {
        const float here = light.red({x, y, z});
        different += here != light.red({kLabSize - x, y, z}) ||
                     here != light.red({x, kLabSize - y, z}) ||
                     here != light.red({x, y, kLabSize - z}) || here != light.red({y, z, x});
      }
  EXPECT_EQ(different, 0);
}

// Row A14 of docs/failure-modes.md.
TEST(FloodfillSteps, frames_between_steps_are_bit_identical) {
  Lab lab({.blocks =
               R"({"block": "glowstone", "at": [12, 14, 18]}, {"block": "stone", "at": [0, 0, 0]})",
           .events = R"({"frame": 12, "set": {"at": [12, 14, 18], "block": "air"}})",
           .options = {{"FLOODFILL_INTERVAL", "3"}}});
  CellField before = lab.light();
  for (int frame = 0; frame < 24; ++frame) {
    lab.step();
    CellField now = lab.light();
    EXPECT_EQ(now == before, frame % 3 != 0) << "frame " << frame;
    before = std::move(now);
  }
}

// Row A16 of docs/failure-modes.md.
// The eye stands so that the lamp is in the last cell of an axis: 31 cells of 64 away.
TEST(FloodfillVolume, lamp_at_an_edge_of_the_volume_lights_no_other_tile) {
  for (const int corner : {0, 2, 5, 7}) {
    const glm::bvec3 high(corner & 1, corner & 2, corner & 4);
    const glm::dvec3 eye = glm::mix(glm::dvec3(32.5), glm::dvec3(-30.5), high);
    PackSession pack({.world = fmt::format(R"({{
           "size": [1, 1, 1],
           "blocks": [{{"block": "glowstone", "at": [0, 0, 0]}}],
           "cameras": [{{"name": "eye", "position": [{}, {}, {}]}}],
           "environment": {{"time": 18000}}
         }})",
                                           eye.x, eye.y, eye.z),
                      .options = {{"GI_METHOD", "FLOODFILL"},
                                  {"FLOODFILL_STORAGE", "ATLAS_2D"},
                                  {"FLOODFILL_INTERVAL", "1"}},
                      .width = 8,
                      .height = 8,
                      .change = runOnlyTheVolume});
    pack.renderFrames(12);
    const CellField light = pack.light();
    const glm::ivec3 lamp = glm::mix(glm::ivec3(0), glm::ivec3(63), high);
    ASSERT_EQ(light.red(lamp), 16) << corner;
    int near = 0;  // what the front reaches in 12 steps
    forEachCell(13, [&](glm::ivec3 away) {
      near += light.red(glm::mix(lamp + away, lamp - away, high)) > 0;
    });
    EXPECT_EQ(near, 13 * 14 * 15 / 6) << corner << ": cells of an octant";
    EXPECT_EQ(light.countLit(), near) << corner;
  }
}

// Nothing comes in over the edge, though the sky is as bright there.
TEST(FloodfillVolume, sky_light_is_too_dark_near_the_edge_of_the_volume_by_the_predicted_shares) {
  Lab lab({.initial = "vec3(11.17)",
           .options = {{"FLOODFILL_SKY", "PUBLISHED"}},
           .constants = {{"SKY_STRENGTH", kSkyOfOne}}});
  lab.step(120);
  const CellField light = lab.light();
  const double errors[] = {.31, .14, .066, .032, .016, .0075, .0037};
  for (int depth = 1; depth <= 7; ++depth)
    EXPECT_NEAR(1 - light.red({depth - 1, 16, 16}) / light.red({16, 16, 16}), errors[depth - 1],
                .005)
        << depth;
}

// Row A18 of docs/failure-modes.md.
TEST(FloodfillWalls, closed_wall_lets_nothing_through) {
  Lab lab({.blocks = R"({"hollow": "stone", "min": [14, 14, 14], "max": [18, 18, 18]},
                        {"block": "glowstone", "at": [16, 16, 16]})"});
  lab.step(20);
  EXPECT_EQ(lab.light().countLit(), 27) << "the inside";
}

// Blocks that touch along edges only: light would have to go diagonally.
TEST(FloodfillWalls, wall_of_touching_edges_lets_nothing_through) {
  std::string blocks = R"({"block": "glowstone", "at": [12, 16, 12]})";
  for (int x = 0; x < kLabSize; ++x)
    blocks += fmt::format(R"(, {{"box": "stone", "min": [{0}, 0, {1}], "max": [{0}, 31, {1}]}})", x,
                          kLabSize - 1 - x);
  Lab lab({.blocks = blocks});
  lab.step(30);
  const CellField light = lab.light();
  EXPECT_GT(light.red({14, 16, 14}), 0);
  int leaks = 0;
  forEachCell(kLabSize, [&](glm::ivec3 c) { leaks += c.x + c.z >= kLabSize && light.red(c) != 0; });
  EXPECT_EQ(leaks, 0);
}

// Half of its cell stays open: light comes to a slab and along it, not through.
TEST(FloodfillWalls, slabs_let_light_in_beside_them_and_not_through) {
  for (const char* storage : {"ATLAS_2D", "IMAGE_3D"})
    for (const char* half : {"bottom", "top"}) {
      const int lampSide = half == std::string("bottom") ? 1 : -1;
      for (const int side : {lampSide, -lampSide}) {
        Lab lab({.blocks = fmt::format(
                     R"({{"box": "stone_slab[type={}]", "min": [0, 16, 0], "max": [31, 16, 31]}},
                        {{"block": "glowstone", "at": [16, {}, 16]}})",
                     half, 16 + 2 * side),
                 .options = {{"FLOODFILL_STORAGE", storage}}});
        lab.step(12);
        const CellField light = lab.light();
        EXPECT_GT(light.red({16, 16 + side, 16}), 0) << storage << half << side;
        EXPECT_EQ(light.red({16, 16, 16}) > 0, side == lampSide) << storage << half << side;
        EXPECT_EQ(light.red({16, 16 - side, 16}), 0) << storage << half << side;
      }
    }
}

// Unlike true light, which a bend would dim far more.
TEST(FloodfillWalls, bend_of_a_corridor_dims_like_its_straight) {
  Lab lab({.blocks = R"({"box": "stone", "min": [8, 15, 8], "max": [24, 17, 24]},
                        {"box": "air", "min": [9, 16, 16], "max": [16, 16, 16]},
                        {"box": "air", "min": [16, 16, 16], "max": [16, 16, 23]},
                        {"block": "glowstone", "at": [12, 16, 16]})"});
  lab.step(60);
  const CellField light = lab.light();
  const glm::ivec3 way[] = {{14, 16, 16}, {15, 16, 16}, {16, 16, 16}, {16, 16, 17}, {16, 16, 18}};
  for (int i = 1; i < 5; ++i)
    EXPECT_NEAR(light.red(way[i]) / light.red(way[i - 1]), .41014, .002) << i;
}

Camera eyeAt(const glm::dvec3& position) {
  Camera camera;
  camera.name = "eye";
  camera.position = position;
  camera.yaw = 180;
  return camera;
}

/// One lamp at `origin`.
PackSession scrollingLamp(glm::ivec3 origin = glm::ivec3(0)) {
  return PackSession({.world = fmt::format(R"({{
      "origin": [{0}, {1}, {2}], "size": [1, 1, 1],
      "blocks": [{{"block": "glowstone", "at": [{0}, {1}, {2}]}}],
      "cameras": [{{"name": "eye", "position": [{0}.5, {1}.5, {3}.5], "yaw": 180}}],
      "environment": {{"time": 18000}}
    }})",
                                           origin.x, origin.y, origin.z, origin.z + 6),
                      .options = {{"GI_METHOD", "FLOODFILL"},
                                  {"FLOODFILL_STORAGE", "ATLAS_2D"},
                                  {"VOXEL_SIZE", "32"}},
                      .width = 8,
                      .height = 8,
                      .change = runOnlyTheVolume});
}

// Row A17 of docs/failure-modes.md.
TEST(FloodfillVolume, light_keeps_its_place_while_the_eye_crosses_zero) {
  PackSession pack = scrollingLamp();
  pack.renderFrames(60);
  const CellField before = pack.light(kLayout);
  const glm::ivec3 start = cellOf({0, 0, 0}, {0, 0, 6}, kLabSize);
  const float steady = before.red(start + glm::ivec3(0, 3, 0));
  for (int axis = 0; axis < 3; ++axis)
    for (double offset = -2.5; offset <= 2.5; offset += 0.4) {
      glm::dvec3 eye(0.5, 0.5, 6.5);
      eye[axis] = offset;
      pack.session().setCamera(eyeAt(eye));
      pack.renderFrames(1);
      const glm::ivec3 lamp = cellOf({0, 0, 0}, glm::ivec3(glm::floor(eye)), kLabSize);
      const CellField light = pack.light(kLayout);
      ASSERT_EQ(light.red(lamp), 16.0f) << axis << ' ' << offset;
      // A shift too much or too little would move the neighbours' light away from the lamp.
      ASSERT_NEAR(light.red(lamp + glm::ivec3(0, 3, 0)) / steady, 1, .01) << axis << ' ' << offset;
      ASSERT_EQ(light.red(lamp + glm::ivec3(1, 0, 0)), light.red(lamp - glm::ivec3(1, 0, 0)))
          << axis << ' ' << offset;
    }
}

// Floats there are two blocks apart.
TEST(FloodfillVolume, light_keeps_its_place_far_away) {
  const glm::ivec3 origin(29999000, 100, 29999000);
  PackSession pack = scrollingLamp(origin);
  pack.renderFrames(60);
  for (const int blocks : {0, 1, 2, 3, 2, 1}) {
    const glm::ivec3 eye = origin + glm::ivec3(blocks, 0, 6);
    pack.session().setCamera(eyeAt(glm::dvec3(eye) + 0.5));
    pack.renderFrames(1);
    const glm::ivec3 lamp = cellOf(origin, eye, kLabSize);
    const CellField light = pack.light(kLayout);
    ASSERT_EQ(light.red(lamp), 16.0f) << blocks;
    for (const glm::ivec3 away : kAway)
      EXPECT_EQ(light.red(lamp + 2 * away), light.red(lamp - 2 * away)) << blocks;
  }
}

TEST(FloodfillVolume, teleport_by_its_size_or_more_leaves_no_light_behind) {
  for (const int distance : {32, 33, 64, -32}) {
    for (int axis = 0; axis < 3; ++axis) {
      PackSession pack = scrollingLamp();
      pack.renderFrames(12);
      ASSERT_GT(pack.light(kLayout).countLit(), 7);
      glm::dvec3 eye(0.5, 0.5, 6.5);
      eye[axis] += distance;
      pack.session().setCamera(eyeAt(eye));
      pack.renderFrames(1);
      // 32 along z: the lamp is still within the volume, and nothing else may be.
      const CellField light = pack.light(kLayout);
      const glm::ivec3 lamp = cellOf({0, 0, 0}, glm::ivec3(glm::floor(eye)), kLabSize);
      const bool inside = glm::all(glm::greaterThanEqual(lamp, glm::ivec3(0))) &&
                          glm::all(glm::lessThan(lamp, glm::ivec3(kLabSize)));
      EXPECT_LE(light.countLit(), inside ? 7 : 0) << axis << ' ' << distance;
    }
  }
}

}  // namespace
}  // namespace orris::test
