// Sun, moon and the shadow camera. Contract: README "Shadow camera", uniforms.csv group world.
#pragma once

#include <glm/glm.hpp>

#include <orris/pack/programs/directives.h>

namespace orris {

/// Fraction of a turn of the sky at `worldTime` ticks; 0 is noon, as the game counts it.
float skyAngleOf(int worldTime);
/// 0 sunrise, 0.25 noon, 0.5 sunset, 0.75 midnight.
float sunAngleOf(float skyAngle);

/// Direction to the sun in world axes, unit length.
glm::vec3 sunDirection(float skyAngle, float sunPathRotation);

/// Direction to sun or moon, whichever casts shadows. Unlike the uniforms, which go through the
/// camera's matrices, it stays the same to the bit while the camera turns.
glm::vec3 shadowLightDirection(float skyAngle, float sunPathRotation);

/// The flash in the sky of the End.
struct EndFlash {
  glm::vec3 direction{0, 1, 0};  ///< world axes, unit length
  float intensity = 0;           ///< 0..1
};
/// In each 600 ticks of the world one flash rises and falls, as in the game; when, for how long and
/// where is this host's own choice, the same for the same `gameTime`.
EndFlash endFlashAt(long long gameTime);

/// Player space to shadow view, with the snap to the interval grid.
glm::mat4 shadowModelViewMatrix(float sunAngle, float sunPathRotation, float interval,
                                const glm::dvec3& cameraPosition);
/// Orthographic, half width `distance`.
glm::mat4 shadowProjectionMatrix(float distance, float nearPlane, float farPlane);

}  // namespace orris
