// What the published listings get wrong in pictures of the whole pack: the shadow factor that is commented out, the albedo
// that is multiplied twice. (Mixed spaces: C4; the window's depth for that of clip space: F3; z-fail that is z-pass: D1.)
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "lab.h"

namespace orris::test {
namespace {

/// A floor, or glass over it, half of it under a roof; `time`: 6000 noon, 18000 night.
std::string groundOf(const std::string& blocks, int time) {
  return fmt::format(R"({{
    "size": [32, 12, 32],
    "blocks": [{{"box": "white_concrete", "min": [0, 0, 0], "max": [31, 0, 31]}}{}],
    "cameras": [{{"name": "eye", "position": [16, 5, 24], "yaw": 180, "pitch": 40}}],
    "environment": {{"time": {}}}}})",
                     blocks, time);
}

const OptionValues kSunAlone{{"GI_METHOD", "NONE"},
                             {"SHADOW_METHOD", "MAP_PCF"},
                             {"AMBIENT_MINIMUM", "0.0"},
                             {"SKY_STRENGTH", "0.0"}};

double lightAt(const std::string& world, double z) {
  PackSession pack(world, kSunAlone, 16, 16);
  pack.look({16, 5, z + 2}, {16, 1, z});
  pack.renderFrames(1);
  return pack.meanRadiance().g;
}

// Without the factor shade is as bright as sun.
TEST(Listing, sun_reaches_no_surface_in_its_shadow) {
  const char* const roof = R"(, {"box": "stone", "min": [0, 8, 0], "max": [31, 8, 15]})";
  const char* const glass =
      R"(, {"box": "white_stained_glass", "min": [0, 1, 0], "max": [31, 1, 31]})";
  for (const std::string& blocks : {std::string(roof), std::string(roof) + glass}) {
    const std::string world = groundOf(blocks, 6000);
    EXPECT_GT(lightAt(world, 26), 0.5) << blocks;
    EXPECT_EQ(lightAt(world, 7), 0) << blocks;
  }
}

/// Mean of the halves of a picture whose surfaces reflect a quarter on its left and a half on its right.
std::pair<double, double> halvesOf(const std::string& world, OptionValues options) {
  constexpr int kWidth = 32;
  options.emplace("GI_METHOD", "NONE");
  options.emplace("SHADOW_METHOD", "NONE");
  SessionSetup setup{.world = world, .options = options, .width = kWidth, .height = kWidth};
  setup.change = [](PackTexts& files) {
    const std::string albedo = "vec3(gl_FragCoord.x < 16.0 ? 0.25 : 0.5);";
    edit(files["/include/gbuffer.glsl"], "to_linear(color.rgb);", albedo);
    std::string& glass = files["/program/gbuffers/translucent.glsl"];
    edit(glass, "to_linear(color.rgb);", albedo);
    edit(glass, "vec4(radiance, mix(color.a, 1.0, fresnel));", "vec4(radiance, 1.0);");
  };
  PackSession pack(setup);
  pack.look({16, 6, 20}, {16, 1, 17});
  pack.renderFrames(1);
  const ImageF image = pack.dump("colortex0");
  std::pair<double, double> sums;
  for (int y = 0; y < kWidth; ++y)
    for (int x = 0; x < kWidth; ++x)
      (x < kWidth / 2 ? sums.first : sums.second) += double(image.at(x, y)[1]);
  return sums;
}

// A grey of one half would be a quarter.
TEST(Listing, every_light_is_multiplied_by_the_albedo_once) {
  const char* const lamps = R"(, {"block": "sea_lantern", "at": [[11, 3, 17], [20, 3, 17]]})";
  const char* const glass =
      R"(, {"box": "white_stained_glass", "min": [6, 1, 6], "max": [25, 1, 25]})";
  for (const std::string& cover : {std::string(), std::string(glass)}) {
    const auto [darker, brighter] = halvesOf(groundOf(cover, 6000), {{"DIRECT_LIGHT", "NONE"}});
    EXPECT_GT(darker, 1) << "ambient" << cover;
    EXPECT_NEAR(darker / brighter, 0.5, 0.005) << "ambient" << cover;
    const auto [dim, bright] =
        halvesOf(groundOf(lamps + cover, 18000), {{"DIRECT_LIGHT", "NONE"},
                                                  {"LIGHT_METHOD", "CLUSTERED"},
                                                  {"SKY_STRENGTH", "0.0"},
                                                  {"AMBIENT_MINIMUM", "0.0"}});
    EXPECT_GT(dim, 1) << "lamps" << cover;
    EXPECT_NEAR(dim / bright, 0.5, 0.005) << "lamps" << cover;
  }
}

}  // namespace
}  // namespace orris::test
