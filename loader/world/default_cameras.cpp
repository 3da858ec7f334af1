#include <cmath>
#include <limits>

#include <orris/world/standing_camera.h>

namespace orris {
namespace {

constexpr float kFov = 70;

bool isFree(const BlockWorld& blocks, glm::ivec3 p) {
  return blocks.contains(p) && blocks.indexAt(p) == 0;
}

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
        const glm::dvec3 d = glm::dvec3(x, y, z) + 0.5 - middle;
        const double distance = glm::dot(d, d);
        if (distance >= bestDistance) continue;
        if (!isFree(blocks, p) || !isFree(blocks, p + glm::ivec3(0, 1, 0))) continue;
        bestDistance = distance;
        best = p;
      }
    }
  }
  return best;
}

}  // namespace

Camera outsideCamera(const BlockWorld& blocks, const std::string& name) {
  constexpr double kPitch = 30;
  const double sine = std::sin(glm::radians(kPitch)), cosine = std::cos(glm::radians(kPitch));
  const glm::dvec3 right(std::sqrt(0.5), 0, std::sqrt(0.5));
  const glm::dvec3 forward(right.x * cosine, -sine, -right.z * cosine);
  const glm::dvec3 up = glm::cross(right, forward);
  const glm::dvec3 half = glm::dvec3(blocks.size()) * 0.5;
  const double slope = std::tan(glm::radians(double(kFov)) / 2) * 0.95;  // a small margin
  double distance = 1;
  for (int i = 0; i < 8; ++i) {
    const glm::dvec3 corner = half * glm::dvec3((i & 1) * 2 - 1, (i & 2) - 1, (i & 4) / 2 - 1);
    const double aside =
        std::max(std::abs(glm::dot(corner, right)), std::abs(glm::dot(corner, up)));
    distance = std::max(distance, aside / slope - glm::dot(corner, forward));
  }
  const glm::dvec3 middle = glm::dvec3(blocks.origin()) + half;
  return {name, middle - forward * distance, 225, float(kPitch), kFov};
}

std::vector<Camera> defaultCameras(const BlockWorld& blocks) {
  std::vector<Camera> cameras{outsideCamera(blocks, "default")};
  if (const auto spot = freeSpot(blocks)) cameras.push_back(standingCamera(blocks, *spot, "inside"));
  return cameras;
}

}  // namespace orris
