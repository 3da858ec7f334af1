// Rays and what they meet.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <limits>

namespace orris {

constexpr std::uint32_t kNoQuad = 0xffffffff;
/// The first quad of every grid: black, for the sides of cubes that no ray should meet.
constexpr std::uint32_t kHiddenQuad = 0;

/// In grid space: world blocks less the grid's origin.
struct Ray {
  glm::vec3 origin{0};
  glm::vec3 direction{0, 0, 1};  ///< unit, no component is 0
  glm::ivec3 cell{0};            ///< where it starts; a full cube is not tested there
  int enteredBy = -1;  ///< axis through which it came into that cell from outside; -1: began in it
  std::uint32_t ignore = kNoQuad;  ///< the quad it starts on
};

struct RayHit {
  std::uint32_t quad = kNoQuad;  ///< kNoQuad: the ray left the world
  /// In blocks; infinity: the ray left the world. As an argument of a walk: nothing is looked for beyond it.
  float distance = std::numeric_limits<float>::infinity();
  bool back = false;    ///< the quad was met from behind
  bool cube = false;    ///< it is the side of a full cube
  glm::ivec3 cell{0};   ///< of the quad
  glm::vec2 at{0};      ///< along the quad's two edges, 0..1
  glm::vec3 filter{1};  ///< what translucent matter on the way lets through
};

/// Directions whose components a division can take.
inline glm::vec3 withoutZeros(glm::vec3 direction) {
  for (int axis = 0; axis < 3; ++axis) {
    if (glm::abs(direction[axis]) < 1e-8f) direction[axis] = direction[axis] < 0 ? -1e-8f : 1e-8f;
  }
  return direction;
}

}  // namespace orris
