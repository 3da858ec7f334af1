#include <orris/plan/frame/clouds.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace orris {
namespace {

// The game's sizes: cells of 12 x 4 x 12 blocks that move west by 0.03 blocks a tick, a third of a
// block above the height of uniform cloudHeight.
constexpr int kCells = 64;
constexpr float kCell = 12, kThickness = 4, kCloudHeight = 192.33f, kBlocksPerSecond = 0.6f;
constexpr double kPeriod = double(kCells) * double(kCell);
// Cells between the points of the noise that makes the pattern; divides kCells.
constexpr int kPatch = 4;
constexpr float kCoverage = 0.42f;

/// A random number at a point of the coarse grid, the same a period on.
float noiseAt(int x, int z) {
  constexpr int kPoints = kCells / kPatch;
  x = (x % kPoints + kPoints) % kPoints;
  z = (z % kPoints + kPoints) % kPoints;
  const auto cell = static_cast<std::uint32_t>(z * kPoints + x);
  return static_cast<float>(mixBits(cell + 0x51a7u) >> 8) / 16777216.0f;
}

bool hasCloud(int x, int z) {
  const int px = x >> 2, pz = z >> 2;
  static_assert(kPatch == 4);
  const float fx = (static_cast<float>(x & 3) + 0.5f) / kPatch;
  const float fz = (static_cast<float>(z & 3) + 0.5f) / kPatch;
  const float near = glm::mix(noiseAt(px, pz), noiseAt(px + 1, pz), fx);
  const float far = glm::mix(noiseAt(px, pz + 1), noiseAt(px + 1, pz + 1), fx);
  return glm::mix(near, far, fz) < kCoverage;
}

/// A side of a cell: its normal, its corners in cells counter-clockwise seen from outside, its shade.
struct CloudSide {
  glm::ivec3 normal;
  std::array<glm::vec3, 4> corners;
  float shade;
};
constexpr CloudSide kSides[] = {{{0, -1, 0}, {{{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}}}, 0.7f},
                                {{0, 1, 0}, {{{0, 1, 0}, {0, 1, 1}, {1, 1, 1}, {1, 1, 0}}}, 1.0f},
                                {{-1, 0, 0}, {{{0, 0, 0}, {0, 0, 1}, {0, 1, 1}, {0, 1, 0}}}, 0.9f},
                                {{1, 0, 0}, {{{1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {1, 0, 1}}}, 0.9f},
                                {{0, 0, -1}, {{{0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}}}, 0.8f},
                                {{0, 0, 1}, {{{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}}, 0.8f}};
constexpr CloudSide kFlat = {{0, 1, 0}, {{{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}}}, 1.0f};

CloudPart addSide(ShapeList& shapes, const CloudSide& side) {
  const size_t start = shapes.vertices.size();
  const glm::vec3 size(kCell, kThickness, kCell);
  for (int z = 0; z < kCells; ++z)
    for (int x = 0; x < kCells; ++x) {
      if (!hasCloud(x, z)) continue;
      const bool open = side.normal.y != 0 || !hasCloud(x + side.normal.x, z + side.normal.z);
      if (!open) continue;
      std::array<glm::vec3, 4> corners;
      for (size_t i = 0; i < 4; ++i) corners[i] = (glm::vec3(x, 0, z) + side.corners[i]) * size;
      shapes.quad(corners, kUnitUv);
    }
  for (size_t v = start; v < shapes.vertices.size(); ++v)
    for (int i = 0; i < 3; ++i)
      shapes.vertices[v].normal[i] = static_cast<std::int8_t>(side.normal[i] * 127);
  return {side.shade, shapes.since(start)};
}

}  // namespace

CloudMesh buildClouds(bool fancy) {
  ShapeList shapes;
  CloudMesh mesh;
  if (fancy) {
    for (const CloudSide& side : kSides) mesh.parts.push_back(addSide(shapes, side));
  } else {
    mesh.parts.push_back(addSide(shapes, kFlat));
  }
  mesh.vertices = std::move(shapes.vertices);
  return mesh;
}

std::vector<glm::vec3> cloudOrigins(const FrameState& state) {
  const double far = state.environment.renderDistance * 4.0;
  const double drift = -double(kBlocksPerSecond) * double(state.frameTimeCounter);
  const auto first = [&](double eye) { return std::floor((eye - far) / kPeriod); };
  const auto last = [&](double eye) { return std::floor((eye + far) / kPeriod); };
  const double eyeX = state.cameraPosition.x - drift, eyeZ = state.cameraPosition.z;
  std::vector<glm::vec3> origins;
  for (double z = first(eyeZ); z <= last(eyeZ); ++z)
    for (double x = first(eyeX); x <= last(eyeX); ++x)
      origins.emplace_back(x * kPeriod - eyeX, double(kCloudHeight) - state.cameraPosition.y,
                           z * kPeriod - eyeZ);
  return origins;
}

float cloudTimeOf(const FrameState& state) { return kBlocksPerSecond * state.frameTimeCounter; }

glm::vec4 cloudColor(const FrameState& state) {
  const float day = std::clamp(std::cos(state.skyAngle * 6.2831853f) * 2 + 0.5f, 0.0f, 1.0f);
  const auto greyed = [](glm::vec3 color, float gray, float amount) {
    const float luma = glm::dot(color, glm::vec3(0.3f, 0.59f, 0.11f));
    return glm::mix(color, glm::vec3(luma * gray), amount * 0.95f);
  };
  glm::vec3 color = greyed(glm::vec3(1), 0.6f, state.environment.rain);
  color *= glm::vec3(day * 0.9f + 0.1f, day * 0.9f + 0.1f, day * 0.85f + 0.15f);
  return {greyed(color, 0.2f, state.environment.thunder), 0.8f};
}

}  // namespace orris
