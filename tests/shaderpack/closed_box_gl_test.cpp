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
              "return is_ball(v.code) ? vec3(0.0) : vec3(is_lamp_voxel(v.code) ? 0.5 : 1.0);");
  replaceOnce(files["/include/gi/hit.glsl"], "return open / max(shown, 1e-3);", "return 1.0;");
  replaceOnce(voxel, "return pow(max(color, vec3(1e-3)), vec3(thickness));", "return vec3(1.0);");
}

/// The same without rays to lamps: then all rays into the hemisphere agree, and nothing is noisy.
void evenGlowByHemisphere(PackTexts& files) {
  evenGlow(files);
  replaceOnce(files["/include/lights/lamp_sample.glsl"], "return sampled / (sampled + max(cosine, 1e-6) / pi);",
              "return 0.0;");
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
void PrintTo(const Thing& thing, std::ostream* out) { *out << thing.name; }

/// Means over the ceiling and over a wall, as shares of what theory says.
struct Held {
  double ceiling = 0, wall = 0;
};

Held heldIn(const Thing& thing, void (*change)(PackTexts&), int frames) {
  SessionSetup setup;
  setup.world = box(thing.blocks);
  setup.options = {{"GI_METHOD", "FACE_CACHE"}, {"VOXEL_SIZE", std::to_string(kFaceVolume)},
                   {"FACE_SHARE", "1"}, {"FACE_WINDOW", "256"}};
  setup.change = change;
  setup.width = setup.height = 8;  // only faces count
  PackSession pack(setup);
  pack.renderFrames(frames);
  const FaceField field = faceField(pack, kFaceVolume);
  return {field.meanRed({1, 6, 1}, {7, 6, 7}, kDown) / kHeld, field.meanRed({0, 3, 1}, {0, 5, 7}, kEast) / kHeld};
}

const Thing kThings[] = {
    {"fire", R"(, {"block": "fire", "at": [[2, 1, 2], [5, 1, 5], [6, 1, 3], [3, 1, 6]]})"},
    {"glass", R"(, {"box": "glass", "min": [2, 1, 2], "max": [5, 3, 3]})"},
    {"lava", R"(, {"box": "lava", "min": [1, 1, 1], "max": [7, 1, 7]})"},
    {"portal", R"(, {"box": "nether_portal[axis=x]", "min": [2, 1, 4], "max": [5, 4, 4]})"},
    {"magma", R"(, {"box": "magma_block", "min": [2, 1, 2], "max": [5, 2, 5]})"},
    {"glowstone", R"(, {"box": "glowstone", "min": [2, 2, 2], "max": [4, 3, 5]})"},
    {"water", R"(, {"box": "water", "min": [1, 1, 1], "max": [7, 3, 5]})"},
    {"stained", R"(, {"box": "red_stained_glass", "min": [2, 1, 5], "max": [5, 3, 6]})"},
    {"pane", R"(, {"box": "glass_pane[north=true,south=true]", "min": [5, 1, 1], "max": [5, 3, 6]})"},
    {"stained_pane", R"(, {"box": "red_stained_glass_pane[north=true,south=true]", "min": [5, 1, 1], "max": [5, 3, 6]})"},
    {"stone", R"(, {"box": "stone", "min": [2, 1, 2], "max": [5, 3, 3]})"},
    {"one_glass", R"(, {"block": "glass", "at": [4, 4, 2]})"}};

class FaceEnergy : public testing::TestWithParam<Thing> {};

TEST_P(FaceEnergy, boxes_hold_e_over_one_less_rho) {
  const Held held = heldIn(GetParam(), evenGlowByHemisphere, 60);
  EXPECT_NEAR(held.ceiling, 1, .01);
  EXPECT_NEAR(held.wall, 1, .01);
}

INSTANTIATE_TEST_SUITE_P(, FaceEnergy, testing::ValuesIn(kThings),
                         [](const auto& tested) { return std::string(tested.param.name); });

// With rays to lamps, 1 to 2 % of noise stay in each mean, of which all boxes together have less.
TEST(FaceEnergyOfLamps, rays_to_lamps_keep_it) {
  double sum = 0;
  for (const Thing& thing : kThings) {
    const Held held = heldIn(thing, evenGlow, 400);
    EXPECT_NEAR(held.ceiling, 1, .04) << thing.name;
    EXPECT_NEAR(held.wall, 1, .04) << thing.name;
    sum += (held.ceiling + held.wall) / 2;
  }
  EXPECT_NEAR(sum / double(std::size(kThings)), 1, .01);
}

}  // namespace
}  // namespace orris::test
