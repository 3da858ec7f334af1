#include <orris/world/mesh/face_light.h>

#include <algorithm>

namespace orris {
namespace {

constexpr float kOccluded = 0.2f;  // the game's shade brightness of full blocks
constexpr float kStep = 16;        // light coordinate of one level

CornerLight operator*(const CornerLight& light, float factor) {
  return {light.occlusion * factor, light.block * factor, light.sky * factor};
}

CornerLight operator+(const CornerLight& a, const CornerLight& b) {
  return {a.occlusion + b.occlusion, a.block + b.block, a.sky + b.sky};
}

bool fillsItsCube(const BlockFacts& facts) {
  return facts.boxes.size() == 1 && facts.boxes[0].from == glm::vec3(0) &&
         facts.boxes[0].to == glm::vec3(16);
}

/// Cells without any light (inside solid blocks) count as lit like the middle one.
CornerLight litLike(CornerLight light, const CornerLight& middle) {
  if (light.block > 0 || light.sky > 0) return light;
  return {light.occlusion, middle.block, middle.sky};
}

/// The mean of the four cells that touch a corner. Between two solid sides the diagonal cell cannot
/// be seen: the first side's values stand for it.
CornerLight meanOf(const CornerLight& middle, const CornerLight& side1, const CornerLight& side2,
                   const CornerLight& diagonal) {
  const bool shut = side1.occlusion < 1 && side2.occlusion < 1;
  return (middle + litLike(side1, middle) + litLike(side2, middle) +
          litLike(shut ? side1 : diagonal, middle)) *
         0.25f;
}

}  // namespace

CornerLight FaceLighting::cellLight(glm::ivec3 cell) const {
  return {occluding_[blocks_.indexAt(cell)] ? kOccluded : 1, float(light_.block(cell)) * kStep,
          float(light_.sky(cell)) * kStep};
}

CornerLight FaceLighting::flatLight(glm::ivec3 cell) const {
  CornerLight light = cellLight(cell);
  light.occlusion = 1;
  return light;
}

CornerLight FaceLighting::fluidLight(const BlockFace& face, glm::ivec3 cell) const {
  const glm::ivec3 up(0, 1, 0);
  const glm::ivec3 low = face.direction == FaceDirection::Down && face.flush ? cell - up : cell;
  const CornerLight first = flatLight(low), second = flatLight(low + up);
  return {1, std::max(first.block, second.block), std::max(first.sky, second.sky)};
}

std::array<CornerLight, 4> FaceLighting::corners(const BlockFace& face, glm::ivec3 cell) const {
  const glm::ivec3 base = face.flush ? cell + normalOf(face.direction) : cell;
  std::array<CornerLight, 4> result;
  if (face.shading != FaceShading::Smooth) {
    result.fill(face.shading == FaceShading::Flat ? flatLight(base) : fluidLight(face, cell));
    return result;
  }
  const glm::ivec2 axes = sideAxes(face.direction);
  CornerLight around[3][3];
  for (int a = 0; a < 3; ++a) {
    for (int b = 0; b < 3; ++b) {
      glm::ivec3 p = base;
      p[axes.x] += a - 1;
      p[axes.y] += b - 1;
      around[a][b] = cellLight(p);
    }
  }
  CornerLight ends[2][2];
  for (int a = 0; a < 2; ++a) {
    for (int b = 0; b < 2; ++b) {
      ends[a][b] = meanOf(around[1][1], around[2 * a][1], around[1][2 * b], around[2 * a][2 * b]);
    }
  }
  for (std::size_t i = 0; i < 4; ++i) {
    // Models may leave their block.
    const float s = std::clamp(face.corners[i][axes.x], 0.0f, 1.0f);
    const float t = std::clamp(face.corners[i][axes.y], 0.0f, 1.0f);
    result[i] = (ends[0][0] * (1 - s) + ends[1][0] * s) * (1 - t) +
                (ends[0][1] * (1 - s) + ends[1][1] * s) * t;
  }
  return result;
}

std::vector<std::uint8_t> occludingStates(const std::vector<BlockFacts>& facts) {
  std::vector<std::uint8_t> occluding;
  for (const BlockFacts& fact : facts) {
    // Leaves darken as full blocks do; glass does not.
    const bool leaves = fact.layer == RenderLayer::Cutout && !fact.cullsSame && !fact.cross &&
                        !fact.air && !fact.fluid && fillsItsCube(fact);
    occluding.push_back(fact.fullOpaqueCube || leaves);
  }
  return occluding;
}

}  // namespace orris
