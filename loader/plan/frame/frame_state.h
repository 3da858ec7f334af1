// Camera, time and weather of one frame: everything the standard uniforms are computed from.
// One plain value, made from the world and the previous frame. Contract: uniforms.csv.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <optional>

#include <orris/pack/programs/directives.h>
#include <orris/pack/properties/volume_lights.h>
#include <orris/world/mesh/light.h>
#include <orris/world/world.h>

namespace orris {

/// Lamps that have shadow volumes: place in player space, range in blocks; 0 where there is none.
using VolumeLights = std::array<glm::vec4, kMostVolumeLights>;

/// Matrices are column-major GL matrices. "player space" has world axes and the eye at the origin.
struct FrameState {
  int width = 0, height = 0;  ///< window, pixels
  int frameCounter = 0;
  float frameTime = 1.0f / 60, frameTimeCounter = 0;  ///< seconds
  unsigned seed = 0;
  Camera camera;
  Environment environment;

  glm::dvec3 cameraPosition{0}, previousCameraPosition{0};  ///< world blocks
  glm::mat4 gbufferModelView{1}, gbufferModelViewInverse{1};
  glm::mat4 gbufferProjection{1}, gbufferProjectionInverse{1};
  glm::mat4 gbufferPreviousModelView{1}, gbufferPreviousProjection{1};
  glm::mat4 shadowModelView{1}, shadowModelViewInverse{1};
  glm::mat4 shadowProjection{1}, shadowProjectionInverse{1};
  float skyAngle = 0, sunAngle = 0, shadowAngle = 0;                                 ///< turns
  glm::vec3 sunPosition{0}, moonPosition{0}, shadowLightPosition{0}, upPosition{0};  ///< view space

  glm::ivec2 eyeBrightness{0, 240};  ///< block, sky; 0..240
  glm::vec2 eyeBrightnessSmooth{0, 240};
  float wetness = 0;
  float centerDepthSmooth = 1;
  bool eyeInBlock = false;   ///< EyeSurroundings::inBlock
  int isEyeInWater = 0;      ///< 0 none, 1 water, 2 lava
  bool feetInWater = false;  ///< the feet are in water and the eye is not
  /// Of the End only. View space, length 100; 0..1 now and in the frame before.
  glm::vec3 endFlashPosition{0};
  float endFlashIntensity = 0, previousEndFlashIntensity = 0;
  VolumeLights volumeLights{};
  /// Of both hands, by item.properties; -1 for none and 0 without the file.
  int heldItemId = -1, heldItemId2 = -1;
  int selectedBlockId = 0;                  ///< by block.properties; 0: none is selected
  glm::vec3 selectedBlockPos{-256};         ///< its middle in player space
  glm::vec4 lightningBolt{0};               ///< player space; w 1 where there is one
};

/// What a frame sees of the world besides blocks that are drawn.
struct EyeSurroundings {
  glm::ivec2 brightness{0, 240};
  int fluid = 0;
  bool inBlock = false;  ///< other than air, fluids and plants: it may see through what is opaque
  bool feetInWater = false;
};

/// An engine's own camera, in OpenGL's conventions; `view` turns player space into view space.
struct ViewMatrices {
  glm::mat4 view{1}, projection{1};
};

/// The state of the next frame; `previous` is null for the first one.
struct FrameInput {
  int width = 0, height = 0;
  unsigned seed = 0;
  Camera camera;
  std::optional<ViewMatrices> matrices{};  ///< in place of those that the camera's angles give
  Environment environment;
  EyeSurroundings eye;
  float centerDepth = 1;  ///< depth under the screen centre, last frame
  float frameTime = 1.0f / 60;
};
FrameState nextFrameState(const FrameInput& input, const PackDirectives& directives,
                          const FrameState* previous);

/// Exponential approach of the contract: acc += (value - acc) * (1 - 2^(-dt / (halflife * 0.1 s))).
float smoothed(float accumulated, float value, float halflife, float frameTime);

}  // namespace orris
