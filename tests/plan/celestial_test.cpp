#include <orris/plan/frame/celestial.h>

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <optional>

#include <orris/plan/frame/frame_state.h>

namespace orris {
namespace {

// Contract README "Shadow camera": the checks the formula comes with.
TEST(Celestial, sun_angle_has_the_values_of_the_game) {
  EXPECT_NEAR(sunAngleOf(skyAngleOf(0)), 0.0345, 5e-4);
  EXPECT_NEAR(sunAngleOf(skyAngleOf(6000)), 0.25, 1e-6);
  EXPECT_NEAR(sunAngleOf(skyAngleOf(18000)), 0.75, 1e-6);
}

TEST(Celestial, sun_is_overhead_at_noon_and_in_the_east_at_sunrise) {
  const glm::vec3 noon = sunDirection(skyAngleOf(6000), 0);
  EXPECT_NEAR(noon.y, 1, 1e-5);
  const glm::vec3 morning = sunDirection(skyAngleOf(500), 0);
  EXPECT_GT(morning.x, 0.9f);
  EXPECT_GT(morning.y, 0);
}

// The sun position and the shadow matrix rotate by opposite conventions; they must meet.
TEST(Celestial, shadow_camera_looks_along_the_light) {
  for (const float tilt : {0.0f, -40.0f, 25.0f})
    for (const int time : {100, 3000, 6000, 11000, 14000, 20000}) {
      const float sky = skyAngleOf(time), sun = sunAngleOf(sky);
      glm::vec3 light = sunDirection(sky, tilt);
      if (sun > 0.5f) light = -light;
      const glm::mat4 view = shadowModelViewMatrix(sun, tilt, 2, {10.25, 70, -3.5});
      const glm::vec3 back = glm::normalize(glm::inverse(glm::mat3(view)) * glm::vec3(0, 0, 1));
      EXPECT_NEAR(glm::distance(back, light), 0, 1e-4) << "time " << time << " tilt " << tilt;
    }
}

TEST(Celestial, shadow_map_is_snapped_to_the_interval) {
  // A world point keeps its place in the map while the camera moves inside one interval.
  const auto place = [](double x) {
    const glm::dvec3 camera(x, 64, 0), point(5, 60, 5);
    const glm::mat4 view = shadowModelViewMatrix(0.2f, 0, 2, camera);
    return glm::vec3(view * glm::vec4(glm::vec3(point - camera), 1));
  };
  EXPECT_NEAR(glm::distance(place(0.1), place(1.9)), 0, 1e-4);
  EXPECT_GT(glm::distance(place(1.9), place(2.1)), 0.1f);
}

FrameInput inputAt(glm::dvec3 position, float yaw, float pitch) {
  FrameInput input;
  input.width = 320;
  input.height = 180;
  input.camera.position = position;
  input.camera.yaw = yaw;
  input.camera.pitch = pitch;
  return input;
}

TEST(FrameState, yaw_and_pitch_follow_the_game) {
  const auto forward = [](float yaw, float pitch) {
    const FrameState s = nextFrameState(inputAt({0, 0, 0}, yaw, pitch), {}, nullptr);
    return glm::vec3(s.gbufferModelViewInverse * glm::vec4(0, 0, -1, 0));
  };
  EXPECT_NEAR(glm::distance(forward(0, 0), glm::vec3(0, 0, 1)), 0, 1e-5);
  EXPECT_NEAR(glm::distance(forward(90, 0), glm::vec3(-1, 0, 0)), 0, 1e-5);
  EXPECT_NEAR(glm::distance(forward(-90, 0), glm::vec3(1, 0, 0)), 0, 1e-5);
  EXPECT_NEAR(glm::distance(forward(0, 90), glm::vec3(0, -1, 0)), 0, 1e-5);
}

TEST(FrameState, previous_values_are_those_of_the_last_frame) {
  const FrameState first = nextFrameState(inputAt({1, 2, 3}, 10, 0), {}, nullptr);
  EXPECT_EQ(first.previousCameraPosition, glm::dvec3(1, 2, 3));
  const FrameState second = nextFrameState(inputAt({4, 5, 6}, 20, 0), {}, &first);
  EXPECT_EQ(second.previousCameraPosition, glm::dvec3(1, 2, 3));
  EXPECT_EQ(second.gbufferPreviousModelView, first.gbufferModelView);
  EXPECT_EQ(second.frameCounter, 1);
}

TEST(FrameState, smoothing_halves_the_distance_in_a_half_life) {
  float value = 0;
  for (int i = 0; i < 60; ++i) value = smoothed(value, 1, 10, 1.0f / 60);  // 10 units = 1 s
  EXPECT_NEAR(value, 0.5, 1e-4);
}

TEST(FrameState, skies_of_other_dimensions_stand_still_and_their_fog_is_not_dimmed) {
  FrameInput input{.width = 4, .height = 4};
  input.environment.fogColor = {0.2f, 0.1f, 0.1f};
  const auto at = [&](const char* dimension, int time) {
    input.environment.dimension = dimension;
    input.environment.time = time;
    return nextFrameState(input, {}, nullptr);
  };
  for (const int time : {0, 6000, 18000}) {
    EXPECT_EQ(at("minecraft:the_nether", time).skyAngle, skyAngleOf(18000));
    EXPECT_EQ(at("minecraft:the_end", time).skyAngle, skyAngleOf(6000));
    EXPECT_EQ(at("minecraft:the_nether", time).environment.fogColor, input.environment.fogColor);
    EXPECT_EQ(at("minecraft:the_nether", time).environment.time, time);
    EXPECT_EQ(at("minecraft:overworld", time).skyAngle, skyAngleOf(time));
  }
  EXPECT_LT(at("minecraft:overworld", 18000).environment.fogColor.r, 0.05f);
}

TEST(FrameState, the_end_flashes_now_and_then) {
  FrameInput input{.width = 4, .height = 4};
  input.environment.dimension = "minecraft:the_end";
  int dark = 0, bright = 0;
  float previous = -1;
  std::optional<FrameState> state;
  for (int time = 0; time < 6000; time += 10) {
    input.environment.time = time;
    state = nextFrameState(input, {}, state ? &*state : nullptr);
    EXPECT_NEAR(glm::length(state->endFlashPosition), 100, 0.01);
    EXPECT_GE(state->endFlashIntensity, 0);
    EXPECT_LE(state->endFlashIntensity, 1);
    if (previous >= 0) {
      EXPECT_EQ(state->previousEndFlashIntensity, previous);
    }
    previous = state->endFlashIntensity;
    ++(previous > 0 ? bright : dark);
  }
  // 100 to 380 of 600 ticks.
  EXPECT_GT(bright, 100);
  EXPECT_GT(dark, 220);
  input.environment.dimension = "minecraft:overworld";
  EXPECT_EQ(nextFrameState(input, {}, nullptr).endFlashPosition, glm::vec3(0));
}

}  // namespace
}  // namespace orris
