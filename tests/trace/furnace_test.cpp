// Rooms in which theory knows the light to the last digit.
#include <gtest/gtest.h>

#include "cube_scene.h"

namespace orris {
namespace {

using test::Cubes;
using test::Estimate;

constexpr int kSamples = 200000;

Estimate gathered(const TraceScene& scene, const TraceSettings& settings, glm::ivec3 size) {
  const PathTracer tracer(scene, {}, settings);
  RayCounts counts;
  return test::estimate(kSamples, [&](std::uint32_t i) {
    SampleRandom random(1, 0, i);
    const glm::ivec3 cell(1 + int(i) % size.x, 0, 1 + int(i) / size.x % size.z);
    const TraceSurface surface = test::surfaceOn(cell, FaceDirection::Up, random.pair());
    return double(tracer.incoming(surface, random, counts).g);
  });
}

class ClosedBox : public testing::TestWithParam<float> {};

// Every wall of albedo rho gives E: the radiance is E + rho E + rho^2 E + ... everywhere.
TEST_P(ClosedBox, holds_e_over_one_less_rho) {
  const float rho = GetParam();
  const glm::ivec3 size(5, 3, 4);
  const TraceScene scene = test::sceneOf(test::roomOf(size, {glm::vec3(rho), glm::vec3(1)}));
  const Estimate result = gathered(scene, {}, size);
  const double expected = 1 / (1 - double(rho));
  EXPECT_NEAR(result.mean, expected, 4 * result.error + 1e-6);
  EXPECT_LT(result.error / expected, 0.005);
}

INSTANTIATE_TEST_SUITE_P(Albedo, ClosedBox, testing::Values(0.0f, 0.25f, 0.5f, 0.8f, 0.9f));

// A white thing in a black room that glows: it sends back what it gets, so it cannot be seen.
TEST(WhiteFurnace, hides_a_white_block) {
  Cubes cubes = test::roomOf({7, 7, 7}, {glm::vec3(0), glm::vec3(1)});
  for (const glm::ivec3& cell : {glm::ivec3(3, 3, 3), {4, 3, 3}, {4, 4, 3}, {4, 4, 4}})
    cubes[cell] = {glm::vec3(1), glm::vec3(0)};
  const TraceScene scene = test::sceneOf(cubes);
  const PathTracer tracer(scene, {}, {});
  RayCounts counts;
  for (const int face : {0, 2, 3, 5}) {  // the others touch a block
    const Estimate result = test::estimate(kSamples / 4, [&](std::uint32_t i) {
      SampleRandom random(2, std::uint32_t(face), i);
      const TraceSurface surface = test::surfaceOn({4, 3, 3}, FaceDirection(face), random.pair());
      return double(tracer.incoming(surface, random, counts).g);
    });
    EXPECT_NEAR(result.mean, 1, 4 * result.error + 1e-6) << "face " << face;
  }
}

TEST(WhiteFurnace, cut_off_bounces_lose_the_light_of_the_rest) {
  const glm::ivec3 size(4, 4, 4);
  const TraceScene scene = test::sceneOf(test::roomOf(size, {glm::vec3(0.5f), glm::vec3(1)}));
  for (const auto& [bounces, expected] : {std::pair(0, 0.0), {1, 1.0}, {2, 1.5}, {4, 1.875}}) {
    TraceSettings settings;
    settings.bounces = bounces;
    const Estimate result = gathered(scene, settings, size);
    EXPECT_NEAR(result.mean, expected, 4 * result.error + 1e-6) << bounces << " bounces";
  }
}

}  // namespace
}  // namespace orris
