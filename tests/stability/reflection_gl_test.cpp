// What surfaces reflect of the sun, as a share of what they receive.
#include <gtest/gtest.h>

#include "shadow_lab.h"

namespace orris::test {
namespace {

// Of light from `theta` degrees: 60000 directions that share the cosine; the software rasteriser stops
// loops after 65535 rounds.
constexpr const char* kReflectance = R"(
float reflectance(vec3 albedo, float theta) {
    vec3 n = vec3(0.0, 1.0, 0.0), l = vec3(sin(radians(theta)), cos(radians(theta)), 0.0);
    float sum = 0.0;
    for (int i = 0; i < 100; ++i)
        for (int j = 0; j < 600; ++j) {
            float up = (float(i) + 0.5) / 100.0, turn = (float(j) + 0.5) / 300.0 * pi;
            vec3 v = vec3(sqrt(1.0 - up * up) * vec2(cos(turn), sin(turn)), up).xzy;
            sum += reflect_direct(albedo, n, v, l).g * v.y;
        }
    return sum * (2.0 * pi / 6e4) / l.y;
}
float angle(int i) { return i == 0 ? 0.0 : i == 1 ? 45.0 : i == 2 ? 60.0 : i == 3 ? 75.0 : i == 4 ? 80.0 : i == 5 ? 85.0 : 89.0; }
)";
constexpr int kAngles = 7;

ShadowLab labOf(const char* reflection, const char* probe) {
  return ShadowLab({.probe = probe,
                    .functions = kReflectance,
                    .options = {{"DIRECT_LIGHT", reflection}, {"SHADOW_METHOD", "NONE"}},
                    .width = kAngles});
}

// Row E2 of docs/failure-modes.md.
TEST(Reflection, white_reflects_no_more_than_it_receives) {
  for (const char* const reflection : {"PHONG", "LAMBERT_GGX"}) {
    ShadowLab lab = labOf(reflection, "vec4(reflectance(vec3(1.0), angle(pixel.x)))");
    lab.draw();
    for (int i = 0; i < kAngles; ++i) {
      EXPECT_LE(lab.at(i)[0], 1.005) << reflection << i;
      EXPECT_GT(lab.at(i)[0], 0.9) << reflection << i;
    }
  }
}

// With the power that holds pi, 2 pi / 7 of the light at right angles.
TEST(Reflection, published_lobe_reflects_more_than_it_receives_at_grazing_angles) {
  ShadowLab lab = labOf("PHONG_PUBLISHED",
                        "vec4(reflectance(vec3(0.0), angle(pixel.x)) * pi / published_specular)");
  lab.draw();
  const double shares[] = {.898, .90, .93, 1.13, 1.39, 2.23, 9.19};
  for (int i = 0; i < kAngles; ++i) EXPECT_NEAR(lab.at(i)[0] / shares[i], 1, .02) << i;
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
    ShadowLab lab = labOf(reflection, "vec4(reflectance(vec3(float(pixel.x) / 2.0), 45.0))");
    lab.draw();
    const float black = lab.at(0)[0], grey = lab.at(1)[0], white = lab.at(2)[0];
    EXPECT_NEAR((grey - black) / (white - black), .5, .001) << reflection;
  }
}

}  // namespace
}  // namespace orris::test
