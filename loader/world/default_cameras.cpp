#include <cmath>
#include <limits>

#include "world/world.h"

namespace orris {
namespace {

constexpr float kFov = 70;

/// A cell of air with air above it, nearest to the middle of the box.
std::optional<glm::ivec3> freeSpot(const BlockWorld& blocks) {
  std::optional<glm::ivec3> best;
  double bestDistance = std::numeric_limits<double>::max();
  const glm::ivec3 size = blocks.size();
  const glm::dvec3 middle = glm::dvec3(size) * 0.5;
  for (int y = 0; y < size.y; ++y) {
    for (int z = 0; z < size.z; ++z) {
      for (int x = 0; x < size.x; ++x) {
        const glm::ivec3 p = blocks.origin() + glm::ivec3(x, y, z);
        if (blocks.indexAt(p) != 0 || blocks.indexAt(p + glm::ivec3(0, 1, 0)) != 0) continue;
        const glm::dvec3 d = glm::dvec3(x, y, z) + 0.5 - middle;
        const double distance = glm::dot(d, d);
        if (distance >= bestDistance) continue;
        bestDistance = distance;
        best = p;
      }
    }
  }
  return best;
}

}  // namespace

std::vector<Camera> defaultCameras(const BlockWorld& blocks) {
  const glm::dvec3 size(blocks.size());
  const glm::dvec3 middle = glm::dvec3(blocks.origin()) + size * 0.5;
  // From the south-west above, far enough that the box's sphere fits the vertical field of view.
  const double radius = 0.5 * glm::length(size);
  const double distance = std::max(2.0, radius / std::sin(glm::radians(double(kFov)) / 2));
  constexpr double kPitch = 30;
  const double horizontal = std::cos(glm::radians(kPitch)) * std::sqrt(0.5);
  Camera outside{"default", middle, 225, float(kPitch), kFov};
  outside.position +=
      distance * glm::dvec3(-horizontal, std::sin(glm::radians(kPitch)), horizontal);
  std::vector<Camera> cameras{outside};
  if (const std::optional<glm::ivec3> spot = freeSpot(blocks)) {
    cameras.push_back({"inside", glm::dvec3(*spot) + glm::dvec3(0.5, 1.12, 0.5), 0, 0, kFov});
  }
  return cameras;
}

}  // namespace orris
