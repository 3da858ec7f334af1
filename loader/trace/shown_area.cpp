#include <orris/trace/shown_area.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include <orris/trace/grid/voxel_grid.h>
#include <orris/world/mesh/block_faces.h>

namespace orris {
namespace {

constexpr int kLines = 1 << 15;

constexpr FaceDirection kSides[6] = {FaceDirection::West, FaceDirection::East, FaceDirection::Down,
                                     FaceDirection::Up,   FaceDirection::North, FaceDirection::South};

/// A line that comes into the unit cube from outside, as one of an even glow does.
struct InwardLine {
  glm::vec3 origin, direction;
  FaceDirection side;
};

/// The n-th of lines spread evenly over sides, places and directions: the sequence R4 (Roberts 2018).
InwardLine lineAt(int n) {
  constexpr double kSteps[4] = {0.8566748838545029, 0.7338918566271260, 0.6287067210378087,
                                0.5385972572236101};
  float u[4];
  for (int i = 0; i < 4; ++i) u[i] = float(std::fmod(0.5 + (n + 1) * kSteps[i], 1.0));
  const int side = n % 6, axis = side / 2;
  const float inward = side % 2 == 0 ? 1 : -1;
  const float radius = std::sqrt(u[2]), angle = 2 * std::numbers::pi_v<float> * u[3];
  InwardLine line{glm::vec3(0), glm::vec3(0), kSides[side]};
  line.origin[axis] = inward > 0 ? 0 : 1;
  line.origin[(axis + 1) % 3] = u[0];
  line.origin[(axis + 2) % 3] = u[1];
  line.direction[axis] = inward * std::sqrt(1 - u[2]);
  line.direction[(axis + 1) % 3] = radius * std::cos(angle);
  line.direction[(axis + 2) % 3] = radius * std::sin(angle);
  return line;
}

bool meetsFront(const InwardLine& line, const BlockFace& face, const Image8& texture) {
  const glm::vec3 u = face.corners[3] - face.corners[0], v = face.corners[1] - face.corners[0];
  const float slope = glm::dot(face.normal, line.direction);
  if (slope >= 0) return false;
  const float t = glm::dot(face.normal, face.corners[0] - line.origin) / slope;
  const glm::vec3 from = line.origin + line.direction * t - face.corners[0];
  const glm::vec2 at(glm::dot(from, u) / glm::dot(u, u), glm::dot(from, v) / glm::dot(v, v));
  if (!(at.x >= 0 && at.x < 1 && at.y >= 0 && at.y < 1)) return false;
  const glm::vec2 uv =
      face.uv[0] + (face.uv[3] - face.uv[0]) * at.x + (face.uv[1] - face.uv[0]) * at.y;
  const glm::ivec2 size(texture.width, texture.height);
  const glm::ivec2 texel = glm::clamp(glm::ivec2(uv * glm::vec2(size)), glm::ivec2(0), size - 1);
  return float(texture.at(texel.x, texel.y)[3]) / 255 >= kAlphaTest;
}

}  // namespace

float shownArea(const BlockFacts& facts, const BlockAtlas& atlas, std::uint8_t sides) {
  constexpr float kCubeArea = 6;
  if (facts.fluid || facts.fullOpaqueCube || facts.boxes.empty()) return float(std::popcount(sides));
  const std::vector<BlockFace> faces = makeBlockFaces(facts, atlas).faces;
  int met = 0;
  for (int n = 0; n < kLines; ++n) {
    const InwardLine line = lineAt(n);
    if ((sides >> int(line.side) & 1) == 0) continue;
    met += std::any_of(faces.begin(), faces.end(), [&](const BlockFace& face) {
      return meetsFront(line, face, atlas.albedo);
    });
  }
  return std::max(kCubeArea * float(met) / kLines, 1e-3f);
}

}  // namespace orris
