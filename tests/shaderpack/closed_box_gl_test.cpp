// Energy in a closed box: whatever stands in it, if all lamps send out E and reflect a share rho and all else is white,
// each point sees E / (1 - rho). What a block swallows or invents shows as a factor.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "face_field.h"

namespace orris::test {
namespace {

constexpr double kRho = 0.5, kHeld = 1 / (1 - kRho);  // E = 1

void replaceOnce(std::string& text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  ASSERT_NE(at, std::string::npos) << from;
  text.replace(at, from.size(), to);
}

/// Lamps of one emission and albedo; white walls, glass and water.
void evenGlow(PackTexts& files) {
  std::string& voxel = files["/include/voxels/voxel.glsl"];
  replaceOnce(voxel, "return color * (EMISSION_STRENGTH * share * share);", "return vec3(1.0);");
  replaceOnce(voxel, "return is_ball(v.code) ? vec3(0.0) : v.color;",
              "return is_ball(v.code) ? vec3(0.0) : vec3(v.code >= voxel_lamp ? 0.5 : 1.0);");
  replaceOnce(voxel, "return pow(max(color, vec3(1e-3)), vec3(thickness));", "return vec3(1.0);");
}

std::string box(const std::string& things) {
  return fmt::format(R"({{"size": [9, 7, 9], "blocks": [
      {{"hollow": "sea_lantern", "min": [0, 0, 0], "max": [8, 6, 8]}}{}],
      "cameras": [{{"name": "eye", "position": [4.5, 4.5, 4.5]}}], "environment": {{"time": 18000}}}})",
                     things);
}

struct Thing {
  const char* name;
  const char* blocks;
};

void expectHeld(const Thing& thing) {
  SCOPED_TRACE(thing.name);
  SessionSetup setup;
  setup.world = box(thing.blocks);
  setup.options = {{"GI_METHOD", "FACE_CACHE"}, {"VOXEL_SIZE", std::to_string(kFaceVolume)},
                   {"FACE_SHARE", "1"}, {"FACE_WINDOW", "256"}};
  setup.change = evenGlow;
  PackSession pack(setup);
  pack.renderFrames(100);
  double ceiling = 0, wall = 0;
  constexpr int kTimes = 5;
  for (int i = 0; i < kTimes; ++i) {
    pack.renderFrames(80);
    const FaceField field = faceField(pack, kFaceVolume);
    ceiling += field.meanRed({1, 6, 1}, {7, 6, 7}, kDown) / kTimes;
    wall += field.meanRed({0, 3, 1}, {0, 5, 7}, kEast) / kTimes;
  }
  EXPECT_NEAR(ceiling / kHeld, 1, .01);
  EXPECT_NEAR(wall / kHeld, 1, .02);
}

// Fire is drawn by planes and met as a cube; glass in a heap has sides that are not drawn.
TEST(face_energy, boxes_with_fire_and_glass_hold_e_over_one_less_rho) {
  for (const Thing& thing :
       {Thing{"fire", R"(, {"block": "fire", "at": [[2, 1, 2], [5, 1, 5], [6, 1, 3], [3, 1, 6]]})"},
        Thing{"glass", R"(, {"box": "glass", "min": [2, 1, 2], "max": [5, 3, 3]})"}})
    expectHeld(thing);
}

TEST(face_energy, boxes_with_anything_hold_e_over_one_less_rho) {
  for (const Thing& thing :
       {Thing{"lava", R"(, {"box": "lava", "min": [1, 1, 1], "max": [7, 1, 7]})"},
        Thing{"portal", R"(, {"box": "nether_portal[axis=x]", "min": [2, 1, 4], "max": [5, 4, 4]})"},
        Thing{"magma", R"(, {"box": "magma_block", "min": [2, 1, 2], "max": [5, 2, 5]})"},
        Thing{"glowstone", R"(, {"box": "glowstone", "min": [2, 2, 2], "max": [4, 3, 5]})"},
        Thing{"water", R"(, {"box": "water", "min": [1, 1, 1], "max": [7, 3, 5]})"},
        Thing{"stained", R"(, {"box": "red_stained_glass", "min": [2, 1, 5], "max": [5, 3, 6]})"},
        Thing{"pane", R"(, {"box": "glass_pane[north=true,south=true]", "min": [5, 1, 1], "max": [5, 3, 6]})"},
        Thing{"stone", R"(, {"box": "stone", "min": [2, 1, 2], "max": [5, 3, 3]})"},
        Thing{"one glass", R"(, {"block": "glass", "at": [4, 4, 2]})"}})
    expectHeld(thing);
}

}  // namespace
}  // namespace orris::test
