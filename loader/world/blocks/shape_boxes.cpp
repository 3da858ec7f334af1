#include <orris/world/blocks/shape_boxes.h>

#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <initializer_list>
#include <string_view>

namespace orris {
namespace {

/// Images of the x, y and z axes: an orthogonal map about the cube's centre.
using AxisMap = glm::mat3;

constexpr int kFaceCount = 6;

struct NamedDirection {
  std::string_view name;
  glm::vec3 normal;
};
constexpr std::array<NamedDirection, kFaceCount> kDirections{{{"down", {0, -1, 0}},
                                                              {"up", {0, 1, 0}},
                                                              {"north", {0, 0, -1}},
                                                              {"south", {0, 0, 1}},
                                                              {"west", {-1, 0, 0}},
                                                              {"east", {1, 0, 0}}}};

int faceAlong(const glm::vec3& normal) {
  for (int face = 0; face < kFaceCount; ++face) {
    if (glm::dot(kDirections[face].normal, normal) > 0.5f) return face;
  }
  return 0;
}

int axisOf(int face) { return face < 2 ? 1 : face < 4 ? 2 : 0; }
bool isPositive(int face) { return face == 1 || face == 3 || face == 5; }

/// The direction a property value means: "east", an axis "x", or a sixteenth turn of a sign, where 0
/// faces south and 4 west (nearest quarter).
glm::vec3 directionOf(const std::string& value, const glm::vec3& fallback) {
  for (const NamedDirection& direction : kDirections) {
    if (direction.name == value) return direction.normal;
  }
  if (value == "x") return {1, 0, 0};
  if (value == "y") return {0, 1, 0};
  if (value == "z") return {0, 0, 1};
  if (value.empty() || value.size() > 2 || value.find_first_not_of("0123456789") != value.npos) {
    return fallback;
  }
  constexpr std::array<glm::vec3, 4> kQuarters{{{0, 0, 1}, {-1, 0, 0}, {0, 0, -1}, {1, 0, 0}}};
  return kQuarters[(std::stoi(value) + 2) / 4 % 4];
}

/// Rotation that takes `from` to `to`, the shortest one; the half turn keeps the y axis or, for the
/// y axis itself, x.
AxisMap rotationBetween(const glm::vec3& from, const glm::vec3& to) {
  if (from == to) return AxisMap(1);
  if (from == -to) {
    return from.y != 0 ? AxisMap({1, 0, 0}, {0, -1, 0}, {0, 0, -1})
                       : AxisMap({-1, 0, 0}, {0, 1, 0}, {0, 0, -1});
  }
  const glm::vec3 axis = glm::cross(from, to);
  return glm::outerProduct(axis, axis) + glm::outerProduct(to, from) - glm::outerProduct(from, to);
}

const std::string& propertyOf(const BlockProperties& properties, std::string_view key) {
  static const std::string kNone;
  const auto found = properties.find(std::string(key));
  return found == properties.end() ? kNone : found->second;
}

/// Texture of a face by the part the box names, or by the usual parts for its direction.
std::string textureOf(const std::map<std::string, std::string>& textures, const std::string& part,
                      int face) {
  static const std::array<std::vector<std::string>, kFaceCount> kParts{{{"bottom", "end", "all"},
                                                                        {"top", "end", "all"},
                                                                        {"front", "side", "all"},
                                                                        {"back", "side", "all"},
                                                                        {"west", "side", "all"},
                                                                        {"east", "side", "all"}}};
  if (part == "-") return "";
  if (const auto found = textures.find(part); !part.empty() && found != textures.end()) {
    return found->second;
  }
  for (const std::string& candidate : kParts[face]) {
    if (const auto found = textures.find(candidate); found != textures.end()) return found->second;
  }
  return "missing";
}

ShapeBox texturedBox(const BoxTemplate& box, const std::map<std::string, std::string>& textures) {
  ShapeBox result;
  result.from = box.from;
  result.to = box.to;
  for (int face = 0; face < kFaceCount; ++face) {
    result.textures[face] = textureOf(textures, box.faces[face], face);
  }
  // A plane has two faces only.
  for (int axis = 0; axis < 3; ++axis) {
    if (box.from[axis] != box.to[axis]) continue;
    for (int face = 0; face < kFaceCount; ++face) {
      if (axisOf(face) != axis) result.textures[face].clear();
    }
  }
  return result;
}

ShapeBox mapped(const ShapeBox& box, const AxisMap& map) {
  const glm::vec3 centre(8);
  const glm::vec3 a = map * (box.from - centre) + centre, b = map * (box.to - centre) + centre;
  ShapeBox result;
  result.from = glm::min(a, b);
  result.to = glm::max(a, b);
  for (int face = 0; face < kFaceCount; ++face) {
    result.textures[faceAlong(map * kDirections[face].normal)] = box.textures[face];
  }
  return result;
}

/// Textures run along the shape's own axis: lying along z turns the east and west sides, along x
/// all four.
void turnTextures(ShapeBox& box, const glm::vec3& along) {
  if (along.y != 0) return;
  for (int face = 0; face < kFaceCount; ++face) {
    const bool side = std::abs(glm::dot(kDirections[face].normal, along)) < 0.5f;
    const bool turned = along.x != 0 || axisOf(face) == 0;
    if (side && turned && !box.textures[face].empty()) box.textures[face] += "@90";
  }
}

/// Does `other` fill the space right outside this face of `box`?
bool hides(const ShapeBox& other, const ShapeBox& box, int face) {
  const int axis = axisOf(face);
  const float plane = isPositive(face) ? box.to[axis] : box.from[axis];
  const bool spans = isPositive(face) ? other.from[axis] <= plane && plane < other.to[axis]
                                      : other.from[axis] < plane && plane <= other.to[axis];
  if (!spans) return false;
  for (int i = 0; i < 3; ++i) {
    if (i != axis && (other.from[i] > box.from[i] || other.to[i] < box.to[i])) return false;
  }
  return true;
}

void dropHiddenFaces(std::vector<ShapeBox>& boxes) {
  for (size_t i = 0; i < boxes.size(); ++i) {
    for (int face = 0; face < kFaceCount; ++face) {
      const bool hidden = std::any_of(boxes.begin(), boxes.end(), [&](const ShapeBox& other) {
        return &other != &boxes[i] && hides(other, boxes[i], face);
      });
      if (hidden) boxes[i].textures[face].clear();
    }
  }
}

void appendPart(const ShapePart& part, const BlockProperties& properties,
                const std::map<std::string, std::string>& textures, std::vector<ShapeBox>& boxes) {
  if (!part.when.holds(properties)) return;
  if (part.around.empty()) {
    for (const BoxTemplate& box : part.boxes) boxes.push_back(texturedBox(box, textures));
    return;
  }
  for (int face = 2; face < kFaceCount; ++face) {
    const std::string& value = propertyOf(properties, kDirections[face].name);
    if (std::find(part.around.begin(), part.around.end(), value) == part.around.end()) continue;
    const AxisMap map = rotationBetween({0, 0, -1}, kDirections[face].normal);
    for (const BoxTemplate& box : part.boxes) {
      boxes.push_back(mapped(texturedBox(box, textures), map));
    }
  }
}

}  // namespace

std::vector<ShapeBox> boxesOf(const ShapeTemplate& shape, const BlockProperties& properties,
                              const std::map<std::string, std::string>& textures) {
  std::vector<ShapeBox> boxes;
  for (const ShapePart& part : shape.parts) appendPart(part, properties, textures, boxes);

  AxisMap map(1);
  glm::vec3 along(0, 1, 0);
  if (shape.flip && shape.flip->holds(properties)) map[1][1] = -1;
  if (!shape.rotate.empty()) {
    constexpr glm::vec3 kNorth(0, 0, -1);
    map = rotationBetween(kNorth, directionOf(propertyOf(properties, shape.rotate), kNorth)) * map;
  }
  if (!shape.stand.empty()) {
    along = directionOf(propertyOf(properties, shape.stand), along);
    map = rotationBetween({0, 1, 0}, along) * map;
  }
  for (ShapeBox& box : boxes) {
    box = mapped(box, map);
    turnTextures(box, along);
  }
  dropHiddenFaces(boxes);
  return boxes;
}

std::uint8_t coveredFacesOf(const std::vector<ShapeBox>& boxes) {
  std::uint8_t result = 0;
  for (int face = 0; face < kFaceCount; ++face) {
    const int axis = axisOf(face), u = (axis + 1) % 3, v = (axis + 2) % 3;
    std::bitset<256> texels;
    for (const ShapeBox& box : boxes) {
      const bool onSide = isPositive(face) ? box.to[axis] >= 16 : box.from[axis] <= 0;
      if (!onSide || box.from[axis] == box.to[axis]) continue;
      for (int i = 0; i < 256; ++i) {
        const glm::vec2 p(float(i % 16), float(i / 16));
        if (p.x >= box.from[u] && p.x + 1 <= box.to[u] && p.y >= box.from[v] &&
            p.y + 1 <= box.to[v]) {
          texels.set(size_t(i));
        }
      }
    }
    if (texels.all()) result = std::uint8_t(result | (1u << face));
  }
  return result;
}

}  // namespace orris
