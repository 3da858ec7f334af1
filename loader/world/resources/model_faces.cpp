#include <orris/world/resources/model_faces.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace orris {
namespace {

constexpr float kSixteenth = 1.0f / 16;

/// A quarter turn each, so that all numbers are exact.
glm::mat3 turnX(int quarters) {
  constexpr float kCos[] = {1, 0, -1, 0}, kSin[] = {0, 1, 0, -1};
  const int i = quarters & 3;
  return {{1, 0, 0}, {0, kCos[i], kSin[i]}, {0, -kSin[i], kCos[i]}};
}

glm::mat3 turnY(int quarters) {
  constexpr float kCos[] = {1, 0, -1, 0}, kSin[] = {0, 1, 0, -1};
  const int i = quarters & 3;
  return {{kCos[i], 0, -kSin[i]}, {0, 1, 0}, {kSin[i], 0, kCos[i]}};
}

glm::mat3 matrixOf(const ModelTurn& turn) { return turnY(-turn.y / 90) * turnX(-turn.x / 90); }

FaceDirection nearestDirection(const glm::vec3& normal) {
  int best = 0;
  float most = -2;
  for (int i = 0; i < 6; ++i) {
    const float along = glm::dot(normal, glm::vec3(normalOf(FaceDirection(i))));
    if (along > most + 1e-5f) {
      most = along;
      best = i;
    }
  }
  return FaceDirection(best);
}

FaceDirection turnedSide(FaceDirection direction, const glm::mat3& matrix) {
  return nearestDirection(matrix * glm::vec3(normalOf(direction)));
}

/// Ends of a box in sixteenths that the corners of a side take, as seen from outside: top left, bottom left, bottom
/// right, top right of its texture. Index 0 is the lower end, 1 the upper.
constexpr int kEnds[6][4][3] = {
    {{0, 0, 1}, {0, 0, 0}, {1, 0, 0}, {1, 0, 1}},  // down
    {{0, 1, 0}, {0, 1, 1}, {1, 1, 1}, {1, 1, 0}},  // up
    {{1, 1, 0}, {1, 0, 0}, {0, 0, 0}, {0, 1, 0}},  // north
    {{0, 1, 1}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}},  // south
    {{0, 1, 0}, {0, 0, 0}, {0, 0, 1}, {0, 1, 1}},  // west
    {{1, 1, 1}, {1, 0, 1}, {1, 0, 0}, {1, 1, 0}},  // east
};

/// Of a face without "uv": the texture lies on the whole block, and the box cuts its part out.
std::array<float, 4> uvOfPlace(const glm::vec3& from, const glm::vec3& to,
                               FaceDirection direction) {
  switch (direction) {
    case FaceDirection::Down:
      return {from.x, 16 - to.z, to.x, 16 - from.z};
    case FaceDirection::Up:
      return {from.x, from.z, to.x, to.z};
    case FaceDirection::North:
      return {16 - to.x, 16 - to.y, 16 - from.x, 16 - from.y};
    case FaceDirection::South:
      return {from.x, 16 - to.y, to.x, 16 - from.y};
    case FaceDirection::West:
      return {from.z, 16 - to.y, to.z, 16 - from.y};
    case FaceDirection::East:
      break;
  }
  return {16 - to.z, 16 - to.y, 16 - from.z, 16 - from.y};
}

/// The rectangle of a face on its texture, in sixteenths, and its quarter turns.
struct FaceUv {
  std::array<float, 4> area;
  int quarters = 0;

  glm::vec2 at(int corner) const {
    const int i = (corner + quarters) & 3;
    return {area[i == 0 || i == 1 ? 0 : 2], area[i == 0 || i == 3 ? 1 : 3]};
  }
};

/// From the plane of a south face to that of another: where the game lets the texture of each side lie.
glm::mat3 fromSouth(FaceDirection direction) {
  switch (direction) {
    case FaceDirection::East:
      return turnY(1);
    case FaceDirection::West:
      return turnY(-1);
    case FaceDirection::North:
      return turnY(2);
    case FaceDirection::Up:
      return turnX(-1);
    case FaceDirection::Down:
      return turnX(1);
    case FaceDirection::South:
      break;
  }
  return glm::mat3(1);
}

float signOf(float value) { return float((value > 0) - (value < 0)); }

/// The game's "uvlock": the rectangle turns against the model, its mirroring stays.
FaceUv locked(const FaceUv& face, FaceDirection direction, const glm::mat3& turn) {
  const glm::mat3 matrix = glm::transpose(fromSouth(direction)) * glm::transpose(turn) *
                           fromSouth(turnedSide(direction, turn));
  const auto moved = [&](glm::vec2 uv) {
    return glm::vec2(matrix * glm::vec3(uv - 8.0f, 0)) + 8.0f;
  };
  const glm::vec2 first(face.area[0], face.area[1]), last(face.area[2], face.area[3]);
  const glm::vec2 a = moved(first), b = moved(last);
  FaceUv result;
  for (int i = 0; i < 2; ++i) {
    const bool same = signOf(last[i] - first[i]) == signOf(b[i] - a[i]);
    result.area[std::size_t(i)] = same ? a[i] : b[i];
    result.area[std::size_t(i) + 2] = same ? b[i] : a[i];
  }
  const float angle = float(face.quarters) * glm::half_pi<float>();
  const glm::vec3 towards =
      matrix * glm::vec3(std::round(std::cos(angle)), std::round(std::sin(angle)), 0);
  result.quarters = -int(std::lround(std::atan2(towards.y, towards.x) / glm::half_pi<float>())) & 3;
  return result;
}

glm::mat3 turnAbout(int axis, float degrees) {
  const float angle = glm::radians(degrees);
  const float c = std::cos(angle), s = std::sin(angle);
  const int a = (axis + 1) % 3, b = (axis + 2) % 3;
  glm::mat3 m(1);
  m[a][a] = m[b][b] = c;
  m[a][b] = s;
  m[b][a] = -s;
  return m;
}

glm::mat3 matrixOf(const ElementTurn& turn) {
  glm::mat3 m = turnAbout(2, turn.degrees.z) * turnAbout(1, turn.degrees.y) *
                turnAbout(0, turn.degrees.x);
  for (int axis = 0; turn.rescale && axis < 3; ++axis) {
    const glm::vec3 along = glm::abs(m[axis]);
    m[axis] /= std::max({along.x, along.y, along.z});
  }
  return m;
}

/// Exactly along an axis where it is nearly so.
glm::vec3 snapped(const glm::vec3& v) {
  const glm::vec3 axis(normalOf(nearestDirection(v)));
  return glm::dot(axis, v) > 0.99999f ? axis : v;
}

/// Normal and tangent from corners and texture coordinates. False: the quad has no area.
bool setFrame(ModelFace& face) {
  const glm::vec3 down = face.corners[1] - face.corners[0],
                  across = face.corners[3] - face.corners[0];
  const glm::vec3 normal = glm::cross(down, across);
  if (!(glm::dot(normal, normal) > 1e-12f)) return false;
  face.normal = snapped(glm::normalize(normal));
  face.direction = nearestDirection(face.normal);
  const glm::vec2 uvDown = face.uv[1] - face.uv[0], uvAcross = face.uv[3] - face.uv[0];
  const float area = uvAcross.x * uvDown.y - uvAcross.y * uvDown.x;
  glm::vec3 u = area != 0 ? (across * uvDown.y - down * uvAcross.y) / area : across;
  if (!(glm::dot(u, u) > 0) || std::isinf(glm::dot(u, u))) u = across;
  face.tangent = glm::vec4(snapped(glm::normalize(u)), area < 0 ? -1 : 1);
  return true;
}

/// The game's order of corners for the side that the face looks to, whatever side of its element it was.
void startAtFirstCorner(ModelFace& face) {
  glm::vec3 ends[2] = {face.corners[0], face.corners[0]};
  for (const glm::vec3& corner : face.corners) {
    ends[0] = glm::min(ends[0], corner);
    ends[1] = glm::max(ends[1], corner);
  }
  const int* end = kEnds[int(face.direction)][0];
  const glm::vec3 first(ends[end[0]].x, ends[end[1]].y, ends[end[2]].z);
  for (std::ptrdiff_t i = 0; i < 4; ++i) {
    if (glm::distance(face.corners[std::size_t(i)], first) > 1e-5f) continue;
    std::rotate(face.corners.begin(), face.corners.begin() + i, face.corners.end());
    std::rotate(face.uv.begin(), face.uv.begin() + i, face.uv.end());
    return;
  }
}

}  // namespace

std::vector<ModelFace> facesOf(const ResolvedModel& model, const ModelTurn& turn) {
  const glm::mat3 matrix = matrixOf(turn);
  std::vector<ModelFace> result;
  for (const ElementTemplate& element : model.elements) {
    const glm::vec3 ends[2] = {element.from, element.to};
    const glm::mat3 own = element.turn ? matrixOf(*element.turn) : glm::mat3(1);
    for (int side = 0; side < 6; ++side) {
      const auto& given = element.faces[std::size_t(side)];
      if (!given) continue;
      const auto direction = FaceDirection(side);
      FaceUv uv{given->uv.value_or(uvOfPlace(element.from, element.to, direction)),
                (given->rotation / 90) & 3};
      if (turn.uvLock) uv = locked(uv, direction, matrix);
      ModelFace face;
      for (int i = 0; i < 4; ++i) {
        const int* end = kEnds[side][i];
        glm::vec3 corner(ends[end[0]].x, ends[end[1]].y, ends[end[2]].z);
        if (element.turn) corner = own * (corner - element.turn->origin) + element.turn->origin;
        face.corners[std::size_t(i)] = matrix * (corner * kSixteenth - 0.5f) + 0.5f;
        // Outside of its tile the atlas has other textures.
        face.uv[std::size_t(i)] = glm::clamp(uv.at(i) * kSixteenth, 0.0f, 1.0f);
      }
      if (!setFrame(face)) continue;
      if (!element.turn) startAtFirstCorner(face);
      face.texture = given->texture.empty() ? "missing" : given->texture;
      if (given->cull) face.cull = turnedSide(*given->cull, matrix);
      face.tintIndex = given->tintIndex;
      face.smooth = model.ambientOcclusion;
      face.shade = element.shade;
      result.push_back(std::move(face));
    }
  }
  return result;
}

}  // namespace orris
