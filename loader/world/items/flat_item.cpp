#include <orris/world/items/flat_item.h>

#include <algorithm>

namespace orris {
namespace {

constexpr float kFront = 8.5f / 16, kBack = 7.5f / 16;
constexpr int kMostEdgeTexels = 64;

bool isThere(const Image8& image, int x, int y) {
  return x >= 0 && y >= 0 && x < image.width && y < image.height && image.at(x, y)[3] > 0;
}

/// A rectangle of the texture, in its coordinates.
struct TexelSpan {
  glm::vec2 low{0}, high{1};
};

ModelFace faceOf(const std::string& texture, FaceDirection direction, const TexelSpan& span) {
  ModelFace face;
  face.texture = texture;
  face.direction = direction;
  face.normal = glm::vec3(normalOf(direction));
  face.smooth = false;
  face.uv = {span.low, {span.low.x, span.high.y}, span.high, {span.high.x, span.low.y}};
  const float left = span.low.x, right = span.high.x, top = 1 - span.low.y,
              bottom = 1 - span.high.y;
  const glm::vec3 a(left, top, kFront), b(left, bottom, kFront), c(right, bottom, kFront),
      d(right, top, kFront);
  const glm::vec3 back(0, 0, kBack - kFront);
  switch (direction) {
    case FaceDirection::North:
      face.corners = {d + back, c + back, b + back, a + back};
      face.uv = {face.uv[3], face.uv[2], face.uv[1], face.uv[0]};
      face.tangent = {1, 0, 0, -1};
      return face;
    case FaceDirection::Up:
      face.corners = {a + back, a, d, d + back};
      break;
    case FaceDirection::Down:
      face.corners = {b, b + back, c + back, c};
      break;
    case FaceDirection::West:
      face.corners = {a + back, b + back, b, a};
      break;
    case FaceDirection::East:
      face.corners = {d, c, c + back, d + back};
      break;
    case FaceDirection::South:
      face.corners = {a, b, c, d};
      break;
  }
  const glm::vec3 across = face.corners[3] - face.corners[0];
  face.tangent = glm::vec4(glm::normalize(across), 1);
  return face;
}

/// Edges along rows and columns, each as long as it goes on.
void addEdges(const std::string& texture, const std::vector<const Image8*>& frames, FaceDirection direction,
              std::vector<ModelFace>& faces) {
  const glm::ivec3 out = normalOf(direction);
  const bool rows = out.x == 0;
  const Image8& first = *frames.front();
  const int lines = rows ? first.height : first.width, length = rows ? first.width : first.height;
  const glm::vec2 texel = 1.0f / glm::vec2(first.width, first.height);
  for (int line = 0; line < lines; ++line) {
    int from = -1;
    for (int i = 0; i <= length; ++i) {
      const int x = rows ? i : line, y = rows ? line : i;
      const bool edge = std::ranges::any_of(frames, [&](const Image8* frame) {
        return isThere(*frame, x, y) && !isThere(*frame, x + out.x, y - out.y);
      });
      if (edge && from < 0) from = i;
      if (edge || from < 0) continue;
      const glm::vec2 low = rows ? glm::vec2(from, line) : glm::vec2(line, from);
      const glm::vec2 high = rows ? glm::vec2(i, line + 1) : glm::vec2(line + 1, i);
      faces.push_back(faceOf(texture, direction, {low * texel, high * texel}));
      from = -1;
    }
  }
}

}  // namespace

std::vector<ModelFace> flatItemFaces(const std::string& texture, const std::vector<const Image8*>& frames) {
  std::vector<ModelFace> faces = {faceOf(texture, FaceDirection::South, {}),
                                  faceOf(texture, FaceDirection::North, {})};
  if (frames.front()->width > kMostEdgeTexels || frames.front()->height > kMostEdgeTexels) return faces;
  for (const FaceDirection direction :
       {FaceDirection::Up, FaceDirection::Down, FaceDirection::West, FaceDirection::East})
    addEdges(texture, frames, direction, faces);
  return faces;
}

}  // namespace orris
