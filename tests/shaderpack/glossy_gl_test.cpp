// Mirrors: polished blocks and metals look along one ray into the face cache.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "face_field.h"

namespace orris::test {
namespace {

OptionValues glossyOptions(const char* glossy) {
  return {{"GI_METHOD", "FACE_CACHE"},
          {"VOXEL_SIZE", "32"},
          {"GI_FILTER", "false"},
          {"AMBIENT_MINIMUM", "0.0"},
          {"GI_GLOSSY", glossy}};
}

/// A room with a floor of one block and a far wall of glowstone, and others.
std::string hall(const std::string& floor, const std::string& walls = "black_concrete") {
  return fmt::format(R"({{"size": [11, 9, 13],
      "blocks": [{{"hollow": "{1}", "min": [0, 0, 0], "max": [10, 8, 12]}},
                 {{"box": "{0}", "min": [1, 0, 1], "max": [9, 0, 11]}},
                 {{"box": "glowstone", "min": [1, 1, 0], "max": [9, 7, 0]}}],
      "cameras": [{{"name": "eye", "position": [5.5, 4, 10]}}],
      "environment": {{"time": 18000}}}})",
                     floor, walls);
}

const glm::dvec3 kEye(5.5, 4, 10), kFloor(5.5, 1, 6);

/// Radiance of the far wall's lamps, of the darkest and of the brightest: their own light, and what they reflect of the
/// light that the cache has there.
std::array<glm::dvec3, 2> lampWall(PackSession& pack) {
  const FaceField field = faceField(pack, kFaceVolume);
  const glm::ivec3 eye(kEye);
  const std::array<float, 4> root =
      pack.voxels({.volume = kFaceVolume, .columns = 32}).at(cellOf({5, 4, 0}, eye, kFaceVolume));
  const glm::dvec3 own = 16.0 * glm::dvec3(1, .70, .38);
  std::array<glm::dvec3, 2> radiance = {glm::dvec3(1e9), glm::dvec3(0)};
  for (int i = 0; i < 25; ++i) {
    const std::array<float, 4> light = field.at({3 + i % 5, 2 + i / 5, 0}, kSouth);
    const glm::dvec3 sent =
        own + glm::dvec3(root[0] * root[0] * light[0], root[1] * root[1] * light[1],
                         root[2] * root[2] * light[2]);
    radiance = {glm::min(radiance[0], sent), glm::max(radiance[1], sent)};
  }
  return radiance;
}

double linear(float stored) { return std::pow(double(stored), 2.2); }

/// A metal floor in a room of lamps: what is seen of it by channel, over the share of light that metal of its colour
/// sends back. From 3 blocks above and 4 behind, the mirror image of the wall's middle: cosine 3/5. Lamps all about: the
/// lobe's tail is wider than one wall.
glm::dvec3 mirrored(PackSession& pack) {
  pack.look(kEye, kFloor);
  pack.renderFrames(100);
  const ImageF albedo = pack.dump("colortex1");
  const double half = std::tan(glm::radians(4.0));  // of the field of view
  glm::dvec3 share(0);
  for (int y = 0; y < albedo.height; ++y) {
    for (int x = 0; x < albedo.width; ++x) {
      const double right = half * (2 * (x + .5) / albedo.width - 1), up = half * (1 - 2 * (y + .5) / albedo.height);
      const double cosine = (.6 - .8 * up) / std::sqrt(1 + right * right + up * up);
      for (int channel = 0; channel < 3; ++channel) {
        const double straight = linear(albedo.at(x, y)[channel]);
        share[channel] += (straight + (1 - straight) * std::pow(1 - cosine, 5)) / (albedo.width * albedo.height);
      }
    }
  }
  return pack.meanRadiance() / share;
}

// Lamps that reflect nothing are all equally bright.
TEST(GlossyReflection, metal_shows_the_lamps_that_it_mirrors_in_its_own_colour) {
  SessionSetup setup;
  setup.world = hall("gold_block", "glowstone");
  setup.options = glossyOptions("true");
  setup.change = [](PackTexts& files) {
    const std::string albedo = "return is_ball(v.code) ? vec3(0.0) : v.color;";
    std::string& text = files["/include/voxels/voxel.glsl"];
    const std::size_t at = text.find(albedo);
    ASSERT_NE(at, std::string::npos);
    text.replace(at, albedo.size(), "return is_lamp_voxel(v.code) ? vec3(0.0) : v.color;");
  };
  PackSession pack(setup);
  const glm::dvec3 seen = mirrored(pack);
  for (int channel = 0; channel < 3; ++channel)
    EXPECT_NEAR(seen[channel] / (16 * glm::dvec3(1, .70, .38)[channel]), 1, .03) << channel;
}

TEST(GlossyReflection, metal_shows_what_lamps_reflect) {
  PackSession pack(hall("gold_block", "glowstone"), glossyOptions("true"));
  const glm::dvec3 seen = mirrored(pack);
  const auto [darkest, brightest] = lampWall(pack);
  for (int channel = 0; channel < 3; ++channel) {
    EXPECT_GT(darkest[channel], 1.05 * 16 * glm::dvec3(1, .70, .38)[channel]) << "lamps reflect";
    EXPECT_GT(seen[channel] / darkest[channel], 1 - .03) << channel;
    EXPECT_LT(seen[channel] / brightest[channel], 1 + .03) << channel;
  }
}

TEST(GlossyReflection, a_polished_floor_mirrors_a_little_over_its_diffuse_base) {
  const auto floor = [](const char* glossy) {
    PackSession pack(hall("polished_diorite"), glossyOptions(glossy));
    pack.look(kEye, kFloor);
    pack.renderFrames(100);
    return pack.meanRadiance().r;
  };
  const double fresnel = .05 + .95 * std::pow(.4, 5);
  EXPECT_NEAR((floor("true") - (1 - fresnel) * floor("false")) / (fresnel * 16), 1, .05);
}

TEST(GlossyReflection, what_was_mirrored_is_gone_when_the_eye_moves) {
  PackSession pack(hall("iron_block"), glossyOptions("true"));
  pack.look(kEye, kFloor);
  pack.renderFrames(60);
  ASSERT_GT(pack.meanRadiance().r, 3);
  // Toward the black wall, at the floor that was in the middle.
  pack.look({5.5, 4, 2}, kFloor);
  pack.renderFrames(1);
  const ImageF mirrored = pack.dump("colortex8");
  double sum = 0;
  for (std::size_t i = 0; i < mirrored.pixels.size(); i += 4) sum += double(mirrored.pixels[i]);
  EXPECT_LT(sum / double(mirrored.pixels.size() / 4), .6);
}

// A soul lantern, whose own light has little red, where stairs stood beside a lamp: its body has no faces, and nothing updates what
// those of the stairs have got.
TEST(GlossyReflection, a_lantern_shows_no_light_of_the_stairs_that_it_replaces) {
  const auto mirroredLantern = [](const std::string& before) {
    SessionSetup setup;
    setup.world = R"({"size": [11, 9, 13],
        "blocks": [{"hollow": "black_concrete", "min": [0, 0, 0], "max": [10, 8, 12]},
                   {"box": "iron_block", "min": [1, 0, 1], "max": [9, 0, 11]}, {"block": "soul_lantern", "at": [5, 1, 2]})" +
                  before + R"(],
        "cameras": [{"name": "eye", "position": [5.5, 4, 10]}], "environment": {"time": 18000},
        "events": [{"frame": 60, "set": {"at": [5, 1, 3], "block": "air"}}, {"frame": 60, "set": {"at": [5, 1, 2], "block": "soul_lantern"}}]})";
    setup.options = glossyOptions("true");
    PackSession pack(setup);
    pack.look(kEye, {5.5, 1, 3.2});
    pack.renderFrames(160);
    return pack.meanRadiance().r;
  };
  const std::string stairs = R"(, {"block": "quartz_stairs[facing=north]", "at": [5, 1, 2]}, {"block": "glowstone", "at": [5, 1, 3]})";
  EXPECT_NEAR(mirroredLantern(stairs) / mirroredLantern(""), 1, .02);
}

TEST(GlossyReflection, only_mirrors_need_a_target) {
  for (const auto& [glossy, method, there] : {std::tuple("false", "FACE_CACHE", false),
                                              {"true", "BOUNCE_1", false},
                                              {"true", "FACE_CACHE", true}}) {
    OptionValues values = glossyOptions(glossy);
    values["GI_METHOD"] = method;
    PackSession pack(hall("stone"), values);
    EXPECT_EQ(bool(pack.session().renderer().schedule().target(false, 8)), there) << method;
  }
}

}  // namespace
}  // namespace orris::test
