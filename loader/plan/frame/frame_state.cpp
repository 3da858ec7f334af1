#include <orris/plan/frame/frame_state.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include <orris/plan/frame/celestial.h>
#include <orris/plan/frame/fog.h>
#include <orris/world/dimension_look.h>

namespace orris {
namespace {

constexpr float kNearPlane = 0.05f;

glm::mat4 viewMatrix(const Camera& camera) {
  const glm::mat4 pitch = glm::rotate(glm::mat4(1), glm::radians(camera.pitch), glm::vec3(1, 0, 0));
  return glm::rotate(pitch, glm::radians(camera.yaw + 180), glm::vec3(0, 1, 0));
}

void setView(FrameState& state, const std::optional<ViewMatrices>& matrices) {
  state.gbufferModelView = matrices ? matrices->view : viewMatrix(state.camera);
  state.gbufferModelViewInverse = glm::inverse(state.gbufferModelView);
  // Iris: the far plane lies at four times the render distance; uniform `far` is the latter.
  const float far = static_cast<float>(state.environment.renderDistance) * 4;
  state.gbufferProjection =
      matrices ? matrices->projection
               : glm::perspective(
                     glm::radians(state.camera.fov),
                     static_cast<float>(state.width) / static_cast<float>(state.height), kNearPlane, far);
  state.gbufferProjectionInverse = glm::inverse(state.gbufferProjection);
}

void setShadow(FrameState& state, const PackDirectives& directives) {
  state.shadowModelView =
      shadowModelViewMatrix(state.sunAngle, directives.sunPathRotation,
                            directives.shadowIntervalSize, state.cameraPosition);
  state.shadowModelViewInverse = glm::inverse(state.shadowModelView);
  state.shadowProjection = shadowProjectionMatrix(
      directives.shadowDistance, directives.shadowNearPlane, directives.shadowFarPlane);
  state.shadowProjectionInverse = glm::inverse(state.shadowProjection);
}

void setSky(FrameState& state, const PackDirectives& directives) {
  state.skyAngle = skyAngleOf(skyTimeOf(state.environment));
  state.sunAngle = sunAngleOf(state.skyAngle);
  state.shadowAngle = state.sunAngle > 0.5f ? state.sunAngle - 0.5f : state.sunAngle;
  const glm::mat3 view(state.gbufferModelView);
  state.sunPosition = view * (100.0f * sunDirection(state.skyAngle, directives.sunPathRotation));
  state.moonPosition = -state.sunPosition;
  state.shadowLightPosition = state.sunAngle <= 0.5f ? state.sunPosition : state.moonPosition;
  state.upPosition = view * glm::vec3(0, 100, 0);
}

void setEndFlash(FrameState& state, const FrameState* previous) {
  if (state.environment.dimension != "minecraft:the_end") return;
  const EndFlash flash = endFlashAt(state.environment.day * 24000LL + state.environment.time);
  state.endFlashPosition = glm::mat3(state.gbufferModelView) * (100.0f * flash.direction);
  state.endFlashIntensity = flash.intensity;
  state.previousEndFlashIntensity =
      previous != nullptr ? previous->endFlashIntensity : flash.intensity;
}

// The game darkens sky and fog at night by the height of the sun.
void dimColors(FrameState& state) {
  if (!hasSkylight(state.environment.dimension)) return;
  const float height = std::cos(state.skyAngle * 2 * 3.14159265f) * 2 + 0.5f;
  const float day = std::min(std::max(height, 0.0f), 1.0f);
  state.environment.skyColor *= day;
  state.environment.fogColor *=
      glm::vec3(day * 0.94f + 0.06f, day * 0.94f + 0.06f, day * 0.91f + 0.09f);
}

void setSmoothed(FrameState& state, const FrameInput& input, const PackDirectives& directives,
                 const FrameState* previous) {
  const float dt = input.frameTime;
  const float rain = input.environment.rain;
  state.eyeBrightness = input.eye.brightness;
  state.isEyeInWater = input.eye.fluid;
  state.eyeInBlock = input.eye.inBlock;
  state.feetInWater = input.eye.feetInWater && input.eye.fluid != 1;
  if (previous == nullptr) {
    state.eyeBrightnessSmooth = glm::vec2(input.eye.brightness);
    state.wetness = rain;
    state.centerDepthSmooth = input.centerDepth;
    return;
  }
  for (int i = 0; i < 2; ++i)
    state.eyeBrightnessSmooth[i] =
        smoothed(previous->eyeBrightnessSmooth[i], static_cast<float>(input.eye.brightness[i]),
                 directives.eyeBrightnessHalflife, dt);
  state.wetness = smoothed(
      previous->wetness, rain,
      rain > previous->wetness ? directives.wetnessHalflife : directives.drynessHalflife, dt);
  state.centerDepthSmooth =
      smoothed(previous->centerDepthSmooth, input.centerDepth, directives.centerDepthHalflife, dt);
}

}  // namespace

float smoothed(float accumulated, float value, float halflife, float frameTime) {
  if (halflife <= 0) return value;
  return accumulated + (value - accumulated) * (1 - std::exp2(-frameTime / (halflife * 0.1f)));
}

FrameState nextFrameState(const FrameInput& input, const PackDirectives& directives,
                          const FrameState* previous) {
  FrameState state;
  state.width = input.width;
  state.height = input.height;
  state.seed = input.seed;
  state.camera = input.camera;
  state.environment = input.environment;
  state.frameTime = input.frameTime;
  state.cameraPosition = input.camera.position;
  setView(state, input.matrices);
  setSky(state, directives);
  setEndFlash(state, previous);
  dimColors(state);
  setShadow(state, directives);
  setSmoothed(state, input, directives, previous);
  state.environment.fogColor = fogColorOf(state);
  const FrameState& last = previous != nullptr ? *previous : state;
  state.previousCameraPosition = last.cameraPosition;
  state.gbufferPreviousModelView = last.gbufferModelView;
  state.gbufferPreviousProjection = last.gbufferProjection;
  if (previous != nullptr) {
    // Wraps as in the game, where shaders rely on the values staying exact in a float.
    state.frameCounter = (previous->frameCounter + 1) % 720720;
    state.frameTimeCounter = previous->frameTimeCounter + input.frameTime;
    if (state.frameTimeCounter >= 3600) state.frameTimeCounter = 0;
  }
  return state;
}

}  // namespace orris
