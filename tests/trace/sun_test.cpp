// The direct sun, in pictures that geometry alone decides.
#include <gtest/gtest.h>

#include "cube_scene.h"

namespace orris {
namespace {

const std::map<std::string, std::string> kSunOnly = {
    {"SUN_STRENGTH", "8"}, {"SKY_STRENGTH", "0"}, {"DIRECT_LIGHT", "PHONG"}};

LightingInput sunAt(glm::vec3 direction) {
  LightingInput lighting;
  lighting.options = kSunOnly;
  lighting.sunDirection = lighting.lightDirection = glm::normalize(direction);
  return lighting;
}

/// A floor of 24 x 24 with a pillar of 2 x 5 x 2 on it.
TraceScene pillarScene(const LightingInput& lighting) {
  test::Cubes cubes;
  for (int x = 0; x < 24; ++x)
    for (int z = 0; z < 24; ++z) cubes[{x, 0, z}] = {glm::vec3(0.5f), glm::vec3(0)};
  for (int y = 1; y <= 5; ++y)
    for (int i = 0; i < 4; ++i)
      cubes[{11 + i % 2, y, 11 + i / 2}] = {glm::vec3(0.5f), glm::vec3(0)};
  return test::sceneOf(cubes, lighting);
}

/// Does a ray from the floor meet the pillar? The slab test.
bool isShadowed(glm::dvec2 at, glm::dvec3 toSun) {
  const glm::dvec3 from(at.x, 1, at.y), low(11, 1, 11), high(13, 6, 13);
  double enter = 0, leave = 1e9;
  for (int axis = 0; axis < 3; ++axis) {
    const double a = (low[axis] - from[axis]) / toSun[axis];
    const double b = (high[axis] - from[axis]) / toSun[axis];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter < leave;
}

/// Looks straight down from far above; a pixel is a quarter of a block.
TraceCamera above(int side) {
  TraceCamera camera;
  camera.width = camera.height = side;
  camera.position = {12, 1e4, 12};
  camera.modelViewInverse = glm::mat4(1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1);
  camera.projectionInverse = glm::mat4(0);
  const auto slope = float(12 / (1e4 - 1));
  camera.projectionInverse[0][0] = camera.projectionInverse[1][1] = slope;
  camera.projectionInverse[3] = glm::vec4(0, 0, -1, 1);
  return camera;
}

TEST(Sun, draws_the_shadow_that_the_slab_test_gives) {
  const LightingInput lighting = sunAt({0.5f, 0.7f, 0.31f});
  const TraceScene scene = pillarScene(lighting);
  TraceSettings settings;
  settings.bounces = 0;
  const int side = 96;
  const TraceFilm film = trace(scene, above(side), settings, 1, 1);
  const auto litAt = [&](glm::dvec2 at) {
    const glm::vec3 toViewer(glm::normalize(glm::dvec3(12 - at.x, 1e4 - 1, 12 - at.y)));
    return scene.lighting->lightIrradiance().g *
           scene.lighting
               ->reflectDirect(glm::vec3(0.5f), {0, 1, 0}, toViewer, lighting.sunDirection)
               .g;
  };
  int shadowed = 0, wrong = 0;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const glm::dvec2 at((x + 0.5) / 4, (y + 0.5) / 4);
      if (at.x > 10.9 && at.x < 13.1 && at.y > 10.9 && at.y < 13.1) continue;  // the pillar's top
      const bool dark = isShadowed(at, glm::dvec3(lighting.sunDirection));
      shadowed += dark;
      wrong += std::abs(film.half(0, x, y).g - (dark ? 0 : litAt(at))) > 1e-4;
    }
  }
  EXPECT_GT(shadowed, 100);
  EXPECT_EQ(wrong, 0);
}

// What is left are the bounces, which keep the sun.
TEST(Sun, is_not_seen_directly_without_direct_light) {
  LightingInput lighting = sunAt({0.5f, 0.7f, 0.31f});
  const auto mean = [&lighting](int bounces) {
    TraceSettings settings;
    settings.bounces = bounces;
    return trace(pillarScene(lighting), above(32), settings, 16, 1).noise().mean;
  };
  const double indirect = mean(1) - mean(0);
  lighting.options["DIRECT_LIGHT"] = "NONE";
  EXPECT_EQ(mean(0), 0);
  EXPECT_NEAR(mean(1), indirect, 1e-6);
  EXPECT_GT(indirect, 1e-4);
}

// Every point of an open plain under a sky of radiance L gets L, whatever reflects.
TEST(Sky, lights_a_plain_by_the_mean_over_the_hemisphere) {
  LightingInput lighting;
  lighting.options = {{"SKY_STRENGTH", "1"}};
  const TraceScene scene = pillarScene(lighting);
  const PathTracer tracer(scene, {}, {});
  RayCounts counts;
  const test::Estimate result = test::estimate(200000, [&](std::uint32_t i) {
    SampleRandom random(5, 0, i);
    const TraceSurface top = test::surfaceOn({11, 5, 11}, FaceDirection::Up, random.pair());
    return double(tracer.incoming(top, random, counts).b);
  });
  // Integral of sky_radiance over the hemisphere, weighed by the cosine.
  double expected = 0;
  constexpr int kSteps = 4000;
  for (int i = 0; i < kSteps; ++i) {
    const double height = std::sqrt((i + 0.5) / kSteps);
    const glm::vec3 direction(std::sqrt(1 - height * height), height, 0);
    expected += scene.lighting->skyRadiance(direction).b / kSteps;
  }
  EXPECT_NEAR(result.mean, expected, 4 * result.error);
}

// Light loses nothing on its way: the same point, from wherever it is seen along one line.
TEST(Radiance, is_constant_along_a_ray) {
  LightingInput lighting = sunAt({0.5f, 0.7f, 0.31f});
  lighting.options["SKY_STRENGTH"] = "2";
  const TraceScene scene = pillarScene(lighting);
  const glm::dvec3 point(5.3, 1, 6.7), direction = glm::normalize(glm::dvec3(-0.3, -0.8, 0.52));
  std::vector<double> seen;
  for (const double distance : {1.0, 3.0, 8.0, 40.0, 300.0}) {
    TraceCamera camera;
    camera.width = camera.height = 1;
    camera.position = point - direction * distance;
    camera.projectionInverse = glm::mat4(0);
    camera.projectionInverse[3] = glm::vec4(glm::vec3(direction), 1);
    const PathTracer tracer(scene, camera, {});
    RayCounts counts;
    const PixelView view = tracer.view(0, 0, counts);
    SampleRandom random(1, 2, 3);
    seen.push_back(tracer.sample(view, random, counts).g);
  }
  for (const double radiance : seen) EXPECT_NEAR(radiance, seen[0], 2e-4 * seen[0]);
  EXPECT_GT(seen[0], 0.1);
}

}  // namespace
}  // namespace orris
