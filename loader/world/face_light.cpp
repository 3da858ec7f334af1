#include "world/face_light.h"

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

bool isFullCube(const BlockFacts& facts) {
  return facts.boxes.size() == 1 && facts.boxes[0].from == glm::vec3(0) &&
         facts.boxes[0].to == glm::vec3(16);
}

}  // namespace

CornerLight FaceLighting::cellLight(glm::ivec3 cell) const {
  return {occludes(cell) ? kOccluded : 1, light_.block(cell) * kStep, light_.sky(cell) * kStep};
}

CornerLight FaceLighting::corner(glm::ivec3 base, glm::ivec3 side1, glm::ivec3 side2) const {
  const CornerLight middle = cellLight(base);
  CornerLight first = cellLight(base + side1), second = cellLight(base + side2);
  const bool shut = occludes(base + side1) && occludes(base + side2);
  CornerLight diagonal = shut ? first : cellLight(base + side1 + side2);
  // Cells without any light (inside solid blocks) count as lit like the middle.
  for (CornerLight* light : {&first, &second, &diagonal}) {
    if (light->block > 0 || light->sky > 0) continue;
    light->block = middle.block;
    light->sky = middle.sky;
  }
  return (middle + first + second + diagonal) * 0.25f;
}

std::array<CornerLight, 4> FaceLighting::corners(const BlockFace& face, glm::ivec3 cell) const {
  const glm::ivec3 base = face.flush ? cell + normalOf(face.direction) : cell;
  std::array<CornerLight, 4> result;
  if (!face.smooth) {
    result.fill(cellLight(base));
    for (CornerLight& light : result) light.occlusion = 1;
    return result;
  }
  const glm::ivec2 axes = sideAxes(face.direction);
  CornerLight ends[2][2];
  for (int a = 0; a < 2; ++a) {
    for (int b = 0; b < 2; ++b) {
      glm::ivec3 side1(0), side2(0);
      side1[axes.x] = 2 * a - 1;
      side2[axes.y] = 2 * b - 1;
      ends[a][b] = corner(base, side1, side2);
    }
  }
  for (std::size_t i = 0; i < 4; ++i) {
    const float s = face.corners[i][axes.x], t = face.corners[i][axes.y];
    result[i] = (ends[0][0] * (1 - s) + ends[1][0] * s) * (1 - t) +
                (ends[0][1] * (1 - s) + ends[1][1] * s) * t;
  }
  return result;
}

std::vector<bool> occludingStates(const std::vector<BlockFacts>& facts) {
  std::vector<bool> occluding;
  for (const BlockFacts& fact : facts) {
    // Leaves darken as full blocks do; glass does not.
    const bool leaves = fact.layer == RenderLayer::Cutout && !fact.cullsSame && !fact.cross &&
                        !fact.air && !fact.fluid && isFullCube(fact);
    occluding.push_back(fact.fullOpaqueCube || leaves);
  }
  return occluding;
}

}  // namespace orris
