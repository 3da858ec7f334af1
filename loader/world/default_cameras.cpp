#include <orris/world/standing_camera.h>

#include <cmath>
#include <limits>
#include <utility>

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

/// The corners of what is no air in a box, or of the box where all is air.
std::pair<glm::ivec3, glm::ivec3> filledBox(const BlockWorld& blocks) {
  const glm::ivec3 origin = blocks.origin(), end = origin + blocks.size(),
                   first = sectionOrigin(origin);
  glm::ivec3 low = end, high = origin;
  for (int y = first.y; y < end.y; y += kSectionSize)
    for (int z = first.z; z < end.z; z += kSectionSize)
      for (int x = first.x; x < end.x; x += kSectionSize) {
        const glm::ivec3 from = glm::max(origin, {x, y, z}),
                         to = glm::min(end, glm::ivec3(x, y, z) + kSectionSize);
        if (blocks.uniformSection(from) == 0u) continue;
        for (glm::ivec3 p = from; p.y < to.y; ++p.y)
          for (p.z = from.z; p.z < to.z; ++p.z)
            for (p.x = from.x; p.x < to.x; ++p.x) {
              if (blocks.indexAt(p) == 0) continue;
              low = glm::min(low, p);
              high = glm::max(high, p + 1);
            }
      }
  return low.x < high.x ? std::pair(low, high) : std::pair(origin, end);
}

}  // namespace

Camera outsideCamera(const BlockWorld& blocks, const std::string& name) {
  constexpr double kPitch = 30;
  const double sine = std::sin(glm::radians(kPitch)), cosine = std::cos(glm::radians(kPitch));
  const glm::dvec3 right(std::sqrt(0.5), 0, std::sqrt(0.5));
  const glm::dvec3 forward(right.x * cosine, -sine, -right.z * cosine);
  const glm::dvec3 up = glm::cross(right, forward);
  const auto [low, high] = filledBox(blocks);
  const glm::dvec3 half = glm::dvec3(high - low) * 0.5;
  const double slope = std::tan(glm::radians(double(kFov)) / 2) * 0.95;  // a small margin
  double distance = 1;
  for (int i = 0; i < 8; ++i) {
    const glm::dvec3 corner = half * glm::dvec3((i & 1) * 2 - 1, (i & 2) - 1, (i & 4) / 2 - 1);
    const double aside =
        std::max(std::abs(glm::dot(corner, right)), std::abs(glm::dot(corner, up)));
    distance = std::max(distance, aside / slope - glm::dot(corner, forward));
  }
  const glm::dvec3 middle = glm::dvec3(low) + half;
  return {name, middle - forward * distance, 225, float(kPitch), kFov};
}

std::vector<Camera> defaultCameras(const BlockWorld& blocks) {
  std::vector<Camera> cameras{outsideCamera(blocks, "default")};
  if (const auto spot = freeSpot(blocks))
    cameras.push_back(standingCamera(blocks, *spot, "inside"));
  return cameras;
}

}  // namespace orris
