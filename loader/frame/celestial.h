// Sun, moon and the shadow camera. Contract: README "Shadow camera", uniforms.csv group world.
#pragma once

#include <glm/glm.hpp>

#include "pack/directives.h"

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

/// Player space to shadow view, with the snap to the interval grid.
glm::mat4 shadowModelViewMatrix(float sunAngle, float sunPathRotation, float interval,
                                const glm::dvec3& cameraPosition);
/// Orthographic, half width `distance`.
glm::mat4 shadowProjectionMatrix(float distance, float nearPlane, float farPlane);

}  // namespace orris
