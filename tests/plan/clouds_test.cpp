#include <orris/plan/frame/clouds.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace orris {
namespace {

glm::vec3 positionOf(const GpuVertex& v) { return {v.position[0], v.position[1], v.position[2]}; }

TEST(CloudShapes, faces_look_out_of_boxes_that_are_closed) {
  const CloudMesh mesh = buildClouds(true);
  ASSERT_EQ(mesh.parts.size(), 6u);
  // Each box has a bottom and a top; sides come in pairs.
  EXPECT_EQ(mesh.parts[0].range.quads, mesh.parts[1].range.quads);
  EXPECT_EQ(mesh.parts[2].range.quads, mesh.parts[3].range.quads);
  EXPECT_EQ(mesh.parts[4].range.quads, mesh.parts[5].range.quads);
  EXPECT_GT(mesh.parts[2].range.quads, 0u);
  EXPECT_LT(mesh.parts[2].range.quads, mesh.parts[0].range.quads);
  for (size_t v = 0; v < mesh.vertices.size(); v += 4) {
    const GpuVertex& first = mesh.vertices[v];
    const glm::vec3 a = positionOf(first), b = positionOf(mesh.vertices[v + 1]),
                    c = positionOf(mesh.vertices[v + 2]);
    const glm::vec3 normal = glm::normalize(glm::cross(b - a, c - b));
    for (int i = 0; i < 3; ++i) ASSERT_EQ(normal[i] * 127, float(first.normal[i])) << v;
  }
}

TEST(CloudShapes, flat_clouds_are_the_tops_of_the_boxes) {
  const CloudMesh flat = buildClouds(false), boxes = buildClouds(true);
  ASSERT_EQ(flat.parts.size(), 1u);
  EXPECT_EQ(flat.parts[0].range.quads, boxes.parts[1].range.quads);
}

TEST(CloudShapes, the_layer_hangs_in_the_world_and_drifts_west) {
  FrameState state;
  state.cameraPosition = {100.0, 64.0, -20.0};
  const std::vector<glm::vec3> before = cloudOrigins(state);
  state.frameTimeCounter = 10;
  const std::vector<glm::vec3> later = cloudOrigins(state);
  ASSERT_EQ(before.size(), later.size());
  EXPECT_NEAR(later[0].x - before[0].x, -6, 1e-3);
  EXPECT_EQ(later[0].z, before[0].z);
  EXPECT_NEAR(before[0].y, 192.33 - 64, 1e-3);
  // A period on, the same clouds are in the same places.
  state.frameTimeCounter = 0;
  state.cameraPosition.z += 768;
  EXPECT_EQ(cloudOrigins(state)[0].z, before[0].z);
}

TEST(CloudShapes, the_uniform_says_how_far_they_have_moved) {
  FrameState state;
  state.frameTimeCounter = 10;
  EXPECT_FLOAT_EQ(cloudTimeOf(state), 6);
}

TEST(CloudShapes, periods_cover_all_that_the_far_plane_shows) {
  FrameState state;
  state.environment.renderDistance = 512;
  for (const double x : {-1.0, 0.0, 383.5, 767.9}) {
    state.cameraPosition = {x, 0, -x};
    const std::vector<glm::vec3> origins = cloudOrigins(state);
    for (int axis : {0, 2}) {
      float low = 1e9f, high = -1e9f;
      for (const glm::vec3& origin : origins) {
        low = std::min(low, origin[axis]);
        high = std::max(high, origin[axis] + 768);
      }
      EXPECT_LE(low, -2048) << x;
      EXPECT_GE(high, 2048) << x;
    }
  }
}

TEST(CloudShapes, colour_follows_day_and_rain) {
  FrameState noon;
  EXPECT_EQ(cloudColor(noon), glm::vec4(1, 1, 1, 0.8f));
  FrameState night = noon;
  night.skyAngle = 0.5f;
  EXPECT_NEAR(cloudColor(night).r, 0.1f, 1e-5f);
  EXPECT_NEAR(cloudColor(night).b, 0.15f, 1e-5f);
  FrameState rain = noon;
  rain.environment.rain = 1;
  EXPECT_NEAR(cloudColor(rain).g, 0.62f, 1e-5f);
}

}  // namespace
}  // namespace orris
