#include "app/view/surface/fly_camera.h"

#include <gtest/gtest.h>

#include <cmath>

namespace orris {
namespace {

Camera facing(float yaw, float pitch = 0) {
  Camera camera;
  camera.yaw = yaw;
  camera.pitch = pitch;
  return camera;
}

void expectNear(const glm::dvec3& actual, const glm::dvec3& expected) {
  EXPECT_NEAR(actual.x, expected.x, 1e-6);
  EXPECT_NEAR(actual.y, expected.y, 1e-6);
  EXPECT_NEAR(actual.z, expected.z, 1e-6);
}

TEST(FlyCamera, forward_is_south_at_yaw_0_and_west_at_yaw_90) {
  FlyCamera south(facing(0));
  south.move({.forward = 1}, 0.5);
  expectNear(south.camera().position, {0, 0, 0.5 * south.speed()});
  FlyCamera west(facing(90));
  west.move({.forward = 1}, 0.5);
  expectNear(west.camera().position, {-0.5 * west.speed(), 0, 0});
}

TEST(FlyCamera, right_is_west_when_facing_south) {
  FlyCamera fly(facing(0));
  fly.move({.right = 1}, 1);
  expectNear(fly.camera().position, {-fly.speed(), 0, 0});
}

TEST(FlyCamera, looking_down_does_not_sink) {
  FlyCamera fly(facing(0, 80));
  fly.move({.forward = 1}, 1);
  expectNear(fly.camera().position, {0, 0, fly.speed()});
}

TEST(FlyCamera, diagonals_are_not_faster) {
  FlyCamera fly(facing(30));
  fly.move({.forward = 1, .right = 1, .up = -1}, 1);
  EXPECT_NEAR(glm::length(fly.camera().position), fly.speed(), 1e-6);
}

TEST(FlyCamera, mouse_to_the_right_and_down_turns_right_and_down) {
  FlyCamera fly(facing(0));
  fly.look(100, 40);
  EXPECT_GT(fly.camera().yaw, 0);
  EXPECT_GT(fly.camera().pitch, 0);
}

TEST(FlyCamera, pitch_stops_and_yaw_goes_round) {
  FlyCamera fly(facing(179));
  fly.look(100, 1e6);
  EXPECT_EQ(fly.camera().pitch, 90);
  EXPECT_NEAR(fly.camera().yaw, -166, 1e-3);
  fly.look(0, -1e7);
  EXPECT_EQ(fly.camera().pitch, -90);
}

TEST(FlyCamera, scroll_scales_the_speed_within_limits) {
  FlyCamera fly(facing(0));
  const double speed = fly.speed();
  fly.scroll(2);
  fly.scroll(-2);
  EXPECT_NEAR(fly.speed(), speed, 1e-9);
  fly.scroll(1000);
  EXPECT_EQ(fly.speed(), 256);
  fly.scroll(-1000);
  EXPECT_EQ(fly.speed(), 0.25);
}

}  // namespace
}  // namespace orris
