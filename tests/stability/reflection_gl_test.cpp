// What surfaces reflect of the sun, as a share of what they receive.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>

#include "shadow_lab.h"

namespace orris::test {
namespace {

// A pixel each for 60 x 100 directions v that share the cosine, for light from each of seven angles: what is reflected
// there. The sum is taken here: summed in one loop, NVIDIA's compiler (580.159) weighs the highlight 5.5 times.
constexpr double kDegrees[] = {0, 45, 60, 75, 80, 85, 89};
constexpr int kAngles = 7, kTurns = 60, kHeights = 100;

constexpr const char* kReflected = R"(
float reflected(vec3 albedo, ivec2 pixel) {
    float degrees = float[](0.0, 45.0, 60.0, 75.0, 80.0, 85.0, 89.0)[pixel.x / 60];
    vec3 l = vec3(sin(radians(degrees)), cos(radians(degrees)), 0.0);
    float up = (float(pixel.y) + 0.5) / 100.0, turn = (float(pixel.x % 60) + 0.5) / 30.0 * pi;
    vec3 v = vec3(sqrt(1.0 - up * up) * vec2(cos(turn), sin(turn)), up).xzy;
    return reflect_direct(albedo, vec3(0.0, 1.0, 0.0), v, l).g * v.y;
}
)";

ShadowLab labOf(const char* reflection, const char* probe, int width = kAngles, int height = 1) {
  return ShadowLab({.probe = probe,
                    .functions = kReflected,
                    .options = {{"DIRECT_LIGHT", reflection}, {"SHADOW_METHOD", "NONE"}},
                    .width = width,
                    .height = height});
}

/// The share of the light of each angle that surfaces of that albedo reflect.
std::array<double, kAngles> reflectances(const char* reflection, const char* albedo) {
  ShadowLab lab = labOf(reflection, fmt::format("vec4(reflected(vec3({}), pixel))", albedo).c_str(),
                        kAngles * kTurns, kHeights);
  lab.draw();
  std::array<double, kAngles> shares{};
  for (int x = 0; x < kAngles * kTurns; ++x)
    for (int y = 0; y < kHeights; ++y) shares[std::size_t(x / kTurns)] += lab.at(x, y)[0];
  for (std::size_t i = 0; i < shares.size(); ++i)
    shares[i] *= 2 * glm::pi<double>() / (kTurns * kHeights) / std::cos(glm::radians(kDegrees[i]));
  return shares;
}

// Row E2 of docs/failure-modes.md.
TEST(Reflection, white_reflects_no_more_than_it_receives) {
  for (const char* const reflection : {"PHONG", "LAMBERT_GGX"}) {
    for (const double share : reflectances(reflection, "1.0")) {
      EXPECT_LE(share, 1.005) << reflection;
      EXPECT_GT(share, 0.9) << reflection;
    }
  }
}

// With the power that holds pi, 2 pi / 7 of the light at right angles.
TEST(Reflection, published_lobe_reflects_more_than_it_receives_at_grazing_angles) {
  const double published[] = {.898, .90, .93, 1.13, 1.39, 2.23, 9.19}, specular = .3;
  const auto shares = reflectances("PHONG_PUBLISHED", "0.0");
  for (std::size_t i = 0; i < shares.size(); ++i)
    EXPECT_NEAR(shares[i] * glm::pi<double>() / specular / published[i], 1, .02) << kDegrees[i];
}

// Row E3 of docs/failure-modes.md.
TEST(Reflection, no_highlight_on_faces_turned_away) {
  // The mirror direction of light that comes from below the horizon.
  const char* const probe =
      "vec4(reflect_direct(vec3(1.0), vec3(0.0, 1.0, 0.0),\n"
      "     normalize(vec3(-1.0, tan(radians(float(pixel.x) + 1.0)), 0.0)),\n"
      "     normalize(vec3(1.0, -tan(radians(float(pixel.x) + 1.0)), 0.0))).g)";
  for (const char* const reflection : {"PHONG", "LAMBERT_GGX"}) {
    ShadowLab lab = labOf(reflection, probe);
    lab.draw();
    for (int i = 0; i < kAngles; ++i) EXPECT_EQ(lab.at(i)[0], 0) << reflection << i;
  }
  ShadowLab published = labOf("PHONG_PUBLISHED", probe);
  published.draw();
  EXPECT_GT(published.at(0)[0], 0.05);
}

// The published listing multiplies by the albedo twice: a grey of one half would be a quarter.
TEST(Reflection, reflected_light_is_proportional_to_the_albedo) {
  for (const char* const reflection : {"PHONG", "LAMBERT_GGX", "PHONG_PUBLISHED"}) {
    const double black = reflectances(reflection, "0.0")[1], grey = reflectances(reflection, "0.5")[1],
                 white = reflectances(reflection, "1.0")[1];
    EXPECT_NEAR((grey - black) / (white - black), .5, .001) << reflection;
  }
}

}  // namespace
}  // namespace orris::test
