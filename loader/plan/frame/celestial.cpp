#include <orris/plan/frame/celestial.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <random>

namespace orris {
namespace {

glm::mat4 rotation(float degrees, glm::vec3 axis) {
  return glm::rotate(glm::mat4(1), glm::radians(degrees), axis);
}

}  // namespace

float skyAngleOf(int worldTime) {
  const double d = worldTime / 24000.0 - 0.25;
  const double fraction = d - std::floor(d);
  return static_cast<float>((2 * fraction + 0.5 - std::cos(fraction * 3.14159265358979) / 2) / 3);
}

float sunAngleOf(float skyAngle) { return skyAngle < 0.75f ? skyAngle + 0.25f : skyAngle - 0.75f; }

glm::vec3 sunDirection(float skyAngle, float sunPathRotation) {
  const glm::mat4 turn = rotation(-90, {0, 1, 0}) * rotation(sunPathRotation, {0, 0, 1}) *
                         rotation(360 * skyAngle, {1, 0, 0});
  return glm::vec3(turn * glm::vec4(0, 1, 0, 0));
}

// Iris: ShadowMatrices.
glm::vec3 shadowLightDirection(float skyAngle, float sunPathRotation) {
  const glm::vec3 sun = sunDirection(skyAngle, sunPathRotation);
  return sunAngleOf(skyAngle) <= 0.5f ? sun : -sun;
}

EndFlash endFlashAt(long long gameTime) {
  constexpr long long kPeriod = 600;
  std::minstd_rand random(
      static_cast<unsigned>(gameTime / kPeriod * 2654435761LL % 2147483647 + 1));
  const auto between = [&](float low, float high) {
    return low + (high - low) * static_cast<float>(random() % 4096) / 4095;
  };
  const float begin = between(0, 200), length = between(100, 380);
  const float pitch = between(-60, 10), yaw = between(-180, 180);
  const float phase = (static_cast<float>(gameTime % kPeriod) - begin) / length;
  EndFlash flash;
  // Iris: CelestialUniforms.
  flash.direction = glm::vec3(rotation(180 - yaw, {0, 1, 0}) * rotation(-90 - pitch, {1, 0, 0}) *
                              glm::vec4(0, 1, 0, 0));
  if (phase > 0 && phase < 1) flash.intensity = std::sin(phase * 3.14159265f);
  return flash;
}

glm::mat4 shadowModelViewMatrix(float sunAngle, float sunPathRotation, float interval,
                                const glm::dvec3& cameraPosition) {
  const float angle = sunAngle <= 0.5f ? sunAngle : sunAngle - 0.5f;
  const float sky = angle < 0.25f ? angle + 0.75f : angle - 0.25f;
  glm::mat4 matrix = glm::translate(glm::mat4(1), glm::vec3(0, 0, -100)) * rotation(90, {1, 0, 0}) *
                     rotation(-360 * sky, {0, 0, 1}) * rotation(sunPathRotation, {1, 0, 0});
  if (interval == 0) return matrix;
  glm::vec3 offset;
  for (int i = 0; i < 3; ++i)
    offset[i] = static_cast<float>(std::fmod(cameraPosition[i], interval) - interval / 2);
  return glm::translate(matrix, offset);
}

glm::mat4 shadowProjectionMatrix(float distance, float nearPlane, float farPlane) {
  return glm::ortho(-distance, distance, -distance, distance, nearPlane, farPlane);
}

}  // namespace orris
