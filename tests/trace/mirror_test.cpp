// What polished blocks and metals mirror: the pack's formula, its samples, and rays that look along them.
#include <gtest/gtest.h>

#include "cube_scene.h"

namespace orris {
namespace {

constexpr int kPolished = 1, kMetal = 2;
const glm::vec3 kUp(0, 1, 0);

PackLighting mirrors() {
  LightingInput input;
  input.options = {{"GI_GLOSSY", "true"}, {"DIRECT_LIGHT", "PHONG"}};
  return PackLighting(input);
}

glm::vec3 viewAt(float degrees) {
  const float angle = glm::radians(degrees);
  return {std::sin(angle), std::cos(angle), 0};
}

/// What comes back of an even glow: the formula summed over the hemisphere.
float summed(const PackLighting& light, int gloss, const glm::vec3& albedo, const glm::vec3& v) {
  constexpr int kSteps = 1000;
  double sum = 0;
  for (int i = 0; i < kSteps; ++i) {
    const float polar = (float(i) + .5f) / kSteps * float(M_PI / 2);
    double ring = 0;
    for (int j = 0; j < kSteps; ++j) {
      const float turn = (float(j) + .5f) / kSteps * float(2 * M_PI);
      const glm::vec3 l(std::sin(polar) * std::cos(turn), std::cos(polar),
                        std::sin(polar) * std::sin(turn));
      ring += double(light.reflectGlossy(gloss, albedo, kUp, v, l).g);
    }
    sum += ring * double(std::sin(polar));
  }
  return float(sum * (M_PI / 2 / kSteps) * (2 * M_PI / kSteps));
}

float sampled(const PackLighting& light, int gloss, const glm::vec3& albedo, const glm::vec3& v) {
  constexpr int kSteps = 200;
  double sum = 0;
  for (int i = 0; i < kSteps * kSteps; ++i) {
    const glm::vec2 u((float(i % kSteps) + .5f) / kSteps, (float(i / kSteps) + .5f) / kSteps);
    sum += double(light.mirror(gloss, albedo, kUp, v, u).weight.g);
  }
  return float(sum / (kSteps * kSteps));
}

TEST(Mirror, samples_reflect_what_the_formula_does) {
  const PackLighting light = mirrors();
  for (const float degrees : {0.0f, 45.0f, 75.0f, 85.0f}) {
    const glm::vec3 v = viewAt(degrees);
    // A black polished block has no diffuse base, a metal never.
    EXPECT_NEAR(
        sampled(light, kPolished, glm::vec3(0), v) / summed(light, kPolished, glm::vec3(0), v), 1,
        .01)
        << degrees;
    EXPECT_NEAR(
        sampled(light, kMetal, glm::vec3(.5f), v) / summed(light, kMetal, glm::vec3(.5f), v), 1,
        .01)
        << degrees;
  }
}

TEST(Mirror, white_reflects_at_most_what_it_receives) {
  const PackLighting light = mirrors();
  for (const float degrees : {0.0f, 30.0f, 60.0f, 80.0f, 89.0f}) {
    const glm::vec3 v = viewAt(degrees);
    for (const int gloss : {kPolished, kMetal}) {
      const float all =
          sampled(light, gloss, glm::vec3(1), v) + light.diffuseShare(gloss, glm::vec3(1), v.y).g;
      EXPECT_LE(all, 1.002f) << gloss << ' ' << degrees;
      if (degrees < 70) {
        EXPECT_GT(all, .97f) << gloss << ' ' << degrees;
      }
    }
  }
}

// Every wall of albedo rho gives E: E / (1 - rho) comes from wherever one looks.
TEST(Mirror, a_ray_sees_the_light_of_a_closed_box) {
  const float rho = .5f;
  const TraceScene scene = test::sceneOf(test::roomOf({5, 3, 4}, {glm::vec3(rho), glm::vec3(1)}));
  const PathTracer tracer(scene, {}, {});
  RayCounts counts;
  const glm::vec3 direction = glm::normalize(glm::vec3(.3f, .8f, -.2f));
  const test::Estimate result = test::estimate(100000, [&](std::uint32_t i) {
    SampleRandom random(1, 0, i);
    const TraceSurface surface = test::surfaceOn({2, 0, 2}, FaceDirection::Up, random.pair());
    return double(tracer.incoming(surface, random, counts, &direction).g);
  });
  EXPECT_NEAR(result.mean, 1 / (1 - double(rho)), 4 * result.error);
  EXPECT_LT(result.error, .01);
}

TEST(Mirror, blocks_are_diffuse_without_the_option) {
  LightingInput input;
  EXPECT_EQ(PackLighting(input).gloss(31), 0);
  EXPECT_EQ(mirrors().gloss(31), kMetal);
  EXPECT_EQ(mirrors().gloss(30), kPolished);
  EXPECT_EQ(mirrors().gloss(13), 0);
}

}  // namespace
}  // namespace orris
