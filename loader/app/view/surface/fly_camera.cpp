#include "app/view/surface/fly_camera.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

namespace orris {
namespace {

constexpr double kDegreesPerPixel = 0.15;
constexpr double kSpeedStep = 1.25;
constexpr double kMinSpeed = 0.25, kMaxSpeed = 256;

}  // namespace

void FlyCamera::look(double dx, double dy) {
  const double yaw = camera_.yaw + dx * kDegreesPerPixel;
  camera_.yaw = float(std::remainder(yaw, 360.0));
  camera_.pitch = float(std::clamp(camera_.pitch + dy * kDegreesPerPixel, -90.0, 90.0));
}

void FlyCamera::move(const FlyKeys& keys, double seconds) {
  const double yaw = glm::radians(double(camera_.yaw));
  const glm::dvec3 forward(-std::sin(yaw), 0, std::cos(yaw));
  const glm::dvec3 right(-std::cos(yaw), 0, -std::sin(yaw));
  const glm::dvec3 direction =
      forward * double(keys.forward) + right * double(keys.right) + glm::dvec3(0, keys.up, 0);
  const double length = glm::length(direction);
  if (length == 0) return;
  camera_.position += direction / length * (speed_ * seconds);
}

void FlyCamera::scroll(double steps) {
  speed_ = std::clamp(speed_ * std::pow(kSpeedStep, steps), kMinSpeed, kMaxSpeed);
}

}  // namespace orris
