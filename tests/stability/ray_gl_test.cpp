// Rays in leaps, RAY_WALK=DISTANCE, against rays that go cell by cell.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "lab.h"

namespace orris::test {
namespace {

constexpr int kSide = 64;

// Blocks of each kind far and near, so that leaps of all lengths occur, and changes.
constexpr const char* kWorld = R"({
  "size": [32, 32, 32],
  "blocks": [{"hollow": "white_concrete", "min": [0, 0, 0], "max": [31, 30, 31]},
             {"box": "air", "min": [12, 30, 12], "max": [20, 30, 20]},
             {"block": "stone", "at": [[5, 4, 7], [20, 12, 9], [16, 22, 20], [9, 15, 22], [26, 6, 4]]},
             {"box": "red_concrete", "min": [22, 1, 14], "max": [24, 9, 15]},
             {"box": "blue_stained_glass", "min": [10, 1, 4], "max": [10, 12, 12]},
             {"block": "stone_slab", "at": [[14, 3, 8], [13, 9, 13], [18, 18, 12]]},
             {"block": "stone_slab[type=top]", "at": [[8, 3, 10], [19, 7, 19]]},
             {"block": "torch", "at": [[5, 5, 7], [17, 1, 11]]},
             {"block": "glowstone", "at": [[3, 25, 3], [25, 20, 25]]}],
  "events": [{"frame": 3, "set": {"at": [15, 14, 22], "block": "white_concrete"}},
             {"frame": 3, "set": {"at": [17, 13, 23], "block": "white_concrete"}},
             {"frame": 3, "set": {"at": [16, 15, 20], "block": "white_concrete"}}],
  "cameras": [{"name": "eye", "position": [16.5, 14.5, 27.5], "yaw": 180, "pitch": 10, "fov": 90}],
  "environment": {"time": 18000}
})";

PackSession sessionOf(const char* walk) {
  return PackSession({.world = kWorld,
                      .options = {{"GI_METHOD", "BOUNCE_4"},
                                  {"RAY_WALK", walk},
                                  {"VOXEL_SIZE", "32"},
                                  {"GI_FILTER", "false"},
                                  {"TEMPORAL_ACCUMULATION", "false"}},
                      .width = kSide,
                      .height = kSide});
}

/// Share of the pixels whose paths of four rays found other light.
double different(PackSession& one, PackSession& other) {
  const ImageF a = one.dump("colortex3"), b = other.dump("colortex3");
  int count = 0;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const float p = a.at(x, y)[0], q = b.at(x, y)[0];
      count += !(std::abs(p - q) <= 2e-3f * std::max(p, q) + 1e-5f);
    }
  return count / double(kSide * kSide);
}

// A ray within 1e-5 of an edge may be rounded to either side of it.
TEST(VoxelRays, leaps_find_what_steps_find) {
  PackSession steps = sessionOf("GRID"), leaps = sessionOf("DISTANCE");
  Camera eye = steps.session().camera();
  for (int frame = 0; frame < 7; ++frame) {
    if (frame >= 5) eye.position += glm::dvec3(-1, 0, -1);
    for (PackSession* one : {&steps, &leaps}) {
      one->session().setCamera(eye);
      one->renderFrames(1);
    }
    EXPECT_LT(different(steps, leaps), 1e-3) << "frame " << frame;
  }
  PackSession still = sessionOf("GRID");
  EXPECT_GT((still.renderFrames(1), different(steps, still)), 0.3) << "there is light to compare";
}

}  // namespace
}  // namespace orris::test
