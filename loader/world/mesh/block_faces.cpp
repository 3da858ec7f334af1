#include <orris/world/mesh/block_faces.h>

#include <algorithm>
#include <cmath>

namespace orris {
namespace {

constexpr float kTexels = 16;
// The game's cross model: 0.8 to 15.2 sixteenths along x and z.
constexpr float kCrossLow = 0.8f / 16, kCrossHigh = 15.2f / 16;

/// Directions of u and v of a face as seen from outside; v points down the texture.
struct FaceAxes {
  glm::vec3 u, v;
};
constexpr FaceAxes kFaceAxes[6] = {
    {{1, 0, 0}, {0, 0, -1}},   // down
    {{1, 0, 0}, {0, 0, 1}},    // up
    {{-1, 0, 0}, {0, -1, 0}},  // north
    {{1, 0, 0}, {0, -1, 0}},   // south
    {{0, 0, 1}, {0, -1, 0}},   // west
    {{0, 0, -1}, {0, -1, 0}},  // east
};

/// Texture coordinate 0..1 of a point along an axis: the game crops the tile by position.
float along(glm::vec3 axis, glm::vec3 point) {
  const float value = glm::dot(axis, point);
  return axis.x + axis.y + axis.z > 0 ? value : 1 + value;
}

void setAtlas(BlockFace& face, const AtlasTile& tile) {
  face.midUv = glm::vec2(0);
  for (glm::vec2& uv : face.uv) {
    uv = tile.min + uv * (tile.max - tile.min);
    face.midUv += uv * 0.25f;
  }
}

/// A texture as wide as two blocks shows a quarter of itself on a side.
AtlasTile quarterOf(const AtlasTile& tile) { return {tile.min, (tile.min + tile.max) * 0.5f}; }

int normalAxis(FaceDirection direction) {
  const glm::ivec2 plane = sideAxes(direction);
  return 3 - plane.x - plane.y;
}

/// One side of a box, with texture coordinates of a whole tile 0..1.
BlockFace boxFace(glm::vec3 low, glm::vec3 high, FaceDirection direction) {
  const FaceAxes& axes = kFaceAxes[int(direction)];
  BlockFace face;
  face.direction = direction;
  face.normal = glm::vec3(normalOf(direction));
  // Which end of the box a corner takes along each axis: the sum of the three directions is +-1.
  const glm::vec3 ends[4] = {face.normal - axes.u - axes.v, face.normal - axes.u + axes.v,
                             face.normal + axes.u + axes.v, face.normal + axes.u - axes.v};
  for (std::size_t i = 0; i < 4; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      face.corners[i][axis] = ends[i][axis] > 0 ? high[axis] : low[axis];
    }
    face.uv[i] = {along(axes.u, face.corners[i]), along(axes.v, face.corners[i])};
  }
  // The texture is never mirrored, so v is cross(tangent, normal).
  face.tangent = glm::vec4(axes.u, 1);
  const int axis = normalAxis(direction);
  face.flush = face.normal[axis] > 0 ? high[axis] >= 1 : low[axis] <= 0;
  if (face.flush) face.cull = direction;
  const glm::ivec2 plane = sideAxes(direction);
  face.side = {{low[plane.x], low[plane.y]}, {high[plane.x], high[plane.y]}};
  return face;
}

/// The same quad seen from behind, its texture mirrored.
BlockFace reversed(BlockFace face) {
  std::swap(face.corners[1], face.corners[3]);
  std::swap(face.uv[1], face.uv[3]);
  face.normal = -face.normal;
  face.tangent.w = -face.tangent.w;
  face.direction = opposite(face.direction);
  face.flush = false;
  face.cull.reset();
  return face;
}

void addCross(const BlockFacts& facts, const BlockAtlas& atlas, std::vector<BlockFace>& faces) {
  const AtlasTile tile = atlas.tile(facts.boxes[0].textures[0]);
  const float a = kCrossLow, b = kCrossHigh;
  const glm::vec2 lines[4][2] = {
      {{a, a}, {b, b}}, {{b, b}, {a, a}}, {{a, b}, {b, a}}, {{b, a}, {a, b}}};
  for (const auto& [from, to] : lines) {
    BlockFace face;
    face.corners = {glm::vec3(from.x, 1, from.y), glm::vec3(from.x, 0, from.y),
                    glm::vec3(to.x, 0, to.y), glm::vec3(to.x, 1, to.y)};
    face.uv = {glm::vec2(0, 0), glm::vec2(0, 1), glm::vec2(1, 1), glm::vec2(1, 0)};
    setAtlas(face, tile);
    const glm::vec3 u = glm::normalize(glm::vec3(to.x - from.x, 0, to.y - from.y));
    face.tangent = glm::vec4(u, 1);
    face.normal = glm::cross(glm::vec3(0, -1, 0), u);
    face.direction = face.normal.z > 0 ? FaceDirection::South : FaceDirection::North;
    face.shading = FaceShading::Flat;
    face.tinted = facts.tint != Tint::None;
    faces.push_back(face);
  }
}

}  // namespace

bool SideRectangle::covers(const SideRectangle& other) const {
  return low.x <= other.low.x && low.y <= other.low.y && high.x >= other.high.x &&
         high.y >= other.high.y;
}

glm::ivec2 sideAxes(FaceDirection direction) {
  switch (direction) {
    case FaceDirection::Down:
    case FaceDirection::Up:
      return {0, 2};
    case FaceDirection::North:
    case FaceDirection::South:
      return {0, 1};
    default:
      return {1, 2};
  }
}

FaceDirection opposite(FaceDirection direction) { return FaceDirection(int(direction) ^ 1); }

BlockFaces makeBlockFaces(const BlockFacts& facts, const BlockAtlas& atlas) {
  BlockFaces result;
  if (facts.air || facts.fluid || facts.boxes.empty()) return result;
  if (facts.cross) {
    addCross(facts, atlas, result.faces);
    return result;
  }
  result.hidesBehind = facts.fullOpaqueCube || facts.layer == RenderLayer::Solid;
  for (const ShapeBox& box : facts.boxes) {
    const glm::vec3 low = glm::clamp(box.from / kTexels, 0.0f, 1.0f);
    const glm::vec3 high = glm::clamp(box.to / kTexels, 0.0f, 1.0f);
    for (int i = 0; i < 6; ++i) {
      BlockFace face = boxFace(low, high, FaceDirection(i));
      if (face.flush) result.covered[std::size_t(i)].push_back(face.side);
      if (box.textures[i].empty()) continue;
      setAtlas(face, atlas.tile(box.textures[i]));
      face.shading = facts.emission == 0 ? FaceShading::Smooth : FaceShading::Flat;
      face.tinted = (box.tintedFaces >> i & 1) != 0;
      result.faces.push_back(face);
    }
  }
  return result;
}

std::vector<BlockFace> makeModelFaces(const std::vector<ModelFace>& faces, bool emits,
                                      const BlockAtlas& atlas,
                                      const std::set<std::string>& seeThrough) {
  constexpr float kOnSide = 1e-5f;
  std::vector<BlockFace> result;
  for (const ModelFace& given : faces) {
    BlockFace face{.corners = given.corners,
                   .uv = given.uv,
                   .normal = given.normal,
                   .tangent = given.tangent,
                   .direction = given.direction};
    setAtlas(face, atlas.tile(given.texture));
    const int axis = normalAxis(face.direction);
    const float end = face.normal[axis] > 0 ? 1 : 0;
    face.flush = std::all_of(face.corners.begin(), face.corners.end(), [&](const glm::vec3& corner) {
      return std::abs(corner[axis] - end) < kOnSide;
    });
    face.cull = given.cull;
    if (face.cull) {
      const glm::ivec2 plane = sideAxes(*face.cull);
      glm::vec2 low(1), high(0);
      for (const glm::vec3& corner : face.corners) {
        const glm::vec2 place = glm::clamp(glm::vec2(corner[plane.x], corner[plane.y]), 0.0f, 1.0f);
        low = glm::min(low, place);
        high = glm::max(high, place);
      }
      face.side = {low, high};
    }
    face.tinted = given.tintIndex >= 0;
    face.tintIndex = given.tintIndex;
    face.shading = given.smooth && !emits ? FaceShading::Smooth : FaceShading::Flat;
    face.shade = given.shade;
    face.seeThrough = seeThrough.contains(given.texture);
    result.push_back(face);
  }
  return result;
}

std::vector<BlockFace> makeFluidFaces(const BlockFacts& facts, const BlockAtlas& atlas,
                                      float height, const std::string& flowing) {
  std::vector<BlockFace> faces;
  const std::string none;
  for (std::size_t i = 0; i < 6; ++i) {
    BlockFace face = boxFace(glm::vec3(0), glm::vec3(1, height, 1), FaceDirection(i));
    const bool side = face.normal.y == 0;
    if (side && !flowing.empty())
      setAtlas(face, quarterOf(atlas.tile(flowing)));
    else
      setAtlas(face, atlas.tile(facts.boxes.empty() ? none : facts.boxes[0].textures[i]));
    face.shading = FaceShading::Fluid;
    face.tinted = facts.tint != Tint::None;
    faces.push_back(face);
    if (face.direction == FaceDirection::Up && height < 1) faces.push_back(reversed(face));
  }
  return faces;
}

std::vector<BlockFace> makeFlowingSurface(const BlockFacts& facts, const BlockAtlas& atlas,
                                          float height, const std::string& flowing,
                                          std::size_t heading) {
  constexpr float kQuarterTurn = 1.5707963f, kHalfWidth = 0.25f;
  BlockFace face = boxFace(glm::vec3(0), glm::vec3(1, height, 1), FaceDirection::Up);
  // v runs with the flow: the texture is turned about its middle.
  const float angle = float(heading) * 4 * kQuarterTurn / float(kFlowHeadings) - kQuarterTurn;
  const glm::vec2 u(std::cos(angle), -std::sin(angle)), v(std::sin(angle), std::cos(angle));
  const glm::vec2 ends[] = {-u - v, -u + v, u + v, u - v};
  for (std::size_t i = 0; i < 4; ++i) face.uv[i] = glm::vec2(0.5f) + ends[i] * kHalfWidth;
  face.tangent = glm::vec4(std::cos(angle), 0, std::sin(angle), 1);
  setAtlas(face, atlas.tile(flowing));
  face.shading = FaceShading::Fluid;
  face.tinted = facts.tint != Tint::None;
  return {face, reversed(face)};
}

}  // namespace orris
