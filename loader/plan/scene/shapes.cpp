#include <orris/plan/scene/shapes.h>

#include <algorithm>
#include <cmath>

namespace orris {
namespace {

constexpr int kStars = 780;

float unitFloat(std::uint32_t& state) {
  state = mixBits(state + 0x9e3779b9u);
  return static_cast<float>(state >> 8) / 16777216.0f;
}

GpuVertex shapeVertex(glm::vec3 position, glm::vec2 uv) {
  GpuVertex v;
  for (int i = 0; i < 3; ++i) v.position[i] = position[i];
  for (int i = 0; i < 2; ++i) v.uv[i] = v.midUv[i] = uv[i];
  return v;
}

}  // namespace

std::uint32_t mixBits(std::uint32_t x) {
  x ^= x >> 16;
  x *= 0x7feb352du;
  x ^= x >> 15;
  x *= 0x846ca68bu;
  return x ^ x >> 16;
}

void ShapeList::quad(const std::array<glm::vec3, 4>& corners, const std::array<glm::vec2, 4>& uv) {
  for (int i = 0; i < 4; ++i) vertices.push_back(shapeVertex(corners[i], uv[i]));
}

QuadRange ShapeList::since(size_t start) const {
  return {static_cast<unsigned>(start), static_cast<unsigned>((vertices.size() - start) / 4)};
}

QuadRange addHorizon(ShapeList& shapes) {
  constexpr int kSides = 8, kRadius = 256, kPlane = 384, kTile = 64;
  constexpr float kHeight = 16;
  const std::array<glm::vec2, 4> uv{};
  const size_t start = shapes.vertices.size();
  const auto rim = [](int i, float y) {
    const float a = (static_cast<float>(i) + 0.5f) * 2 * 3.14159265f / kSides;
    return glm::vec3(kRadius * std::cos(a), y, kRadius * std::sin(a));
  };
  for (int i = 0; i < kSides; ++i)
    shapes.quad({{rim(i, -kHeight), rim(i + 1, -kHeight), rim(i + 1, kHeight), rim(i, kHeight)}},
                uv);
  for (int i = -kPlane; i <= kPlane; i += kTile)
    for (int j = -kPlane; j <= kPlane; j += kTile) {
      const auto x = static_cast<float>(i), z = static_cast<float>(j);
      const float x2 = x + kTile, z2 = z + kTile;
      shapes.quad({{{x2, kHeight, z}, {x2, kHeight, z2}, {x, kHeight, z2}, {x, kHeight, z}}}, uv);
      shapes.quad({{{x2, -kHeight, z}, {x, -kHeight, z}, {x, -kHeight, z2}, {x2, -kHeight, z2}}},
                  uv);
    }
  return shapes.since(start);
}

QuadRange addSkyDisc(ShapeList& shapes) {
  const size_t start = shapes.vertices.size();
  const std::array<glm::vec2, 4> center = {
      {{0.5f, 0.5f}, {0.5f, 0.5f}, {0.5f, 0.5f}, {0.5f, 0.5f}}};
  constexpr int kSegments = 8;
  const auto rim = [](int i) {
    const float a = static_cast<float>(i) * 2 * 3.14159265f / kSegments;
    return glm::vec3(512 * std::cos(a), 16, 512 * std::sin(a));
  };
  for (int i = 0; i < kSegments; i += 2)
    shapes.quad({{{0, 16, 0}, rim(i), rim(i + 1), rim(i + 2)}}, center);
  return shapes.since(start);
}

QuadRange addStars(ShapeList& shapes) {
  const size_t start = shapes.vertices.size();
  std::uint32_t random = 10842;
  for (int i = 0; i < kStars; ++i) {
    const float y = unitFloat(random) * 2 - 1, angle = unitFloat(random) * 6.2831853f;
    const float size = 0.15f + unitFloat(random) * 0.1f, r = std::sqrt(1 - y * y);
    const glm::vec3 d(r * std::cos(angle), y, r * std::sin(angle));
    const glm::vec3 side = glm::normalize(
        glm::cross(d, std::abs(d.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0)));
    const glm::vec3 up = glm::cross(side, d);
    const glm::vec3 c = d * 100.0f;
    shapes.quad({{c - (side + up) * size, c + (side - up) * size, c + (side + up) * size,
                  c + (up - side) * size}},
                kUnitUv);
  }
  return shapes.since(start);
}

QuadRange addCelestialQuad(ShapeList& shapes, float y, float size, float u0) {
  const size_t start = shapes.vertices.size();
  shapes.quad({{{-size, y, -size}, {size, y, -size}, {size, y, size}, {-size, y, size}}},
              {{{u0, 0}, {u0 + 0.5f, 0}, {u0 + 0.5f, 1}, {u0, 1}}});
  return shapes.since(start);
}

QuadRange addEndCube(ShapeList& shapes) {
  constexpr float kHalf = 100, kRepeats = 16;
  const std::array<glm::vec2, 4> uv = {{{0, 0}, {0, kRepeats}, {kRepeats, kRepeats}, {kRepeats, 0}}};
  const size_t start = shapes.vertices.size();
  for (int axis = 0; axis < 3; ++axis)
    for (const float side : {-kHalf, kHalf}) {
      // Seen from inside.
      const auto corner = [&](float u, float v) {
        glm::vec3 place;
        place[axis] = side;
        place[(axis + 1) % 3] = side < 0 ? u : v;
        place[(axis + 2) % 3] = side < 0 ? v : u;
        return place;
      };
      shapes.quad({{corner(-kHalf, -kHalf), corner(kHalf, -kHalf), corner(kHalf, kHalf), corner(-kHalf, kHalf)}}, uv);
    }
  return shapes.since(start);
}

Image8 endSkyImage() {
  constexpr int kSide = 128;
  Image8 image(kSide, kSide, 4);
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const auto fine = mixBits(static_cast<std::uint32_t>(y * kSide + x)) % 64;
      const auto coarse = mixBits(static_cast<std::uint32_t>(y / 8 * 64 + x / 8) + 977) % 96;
      const auto tone = static_cast<std::uint8_t>(60 + fine + coarse);
      std::uint8_t* texel = image.at(x, y);
      texel[0] = tone;
      texel[1] = static_cast<std::uint8_t>(tone * 3 / 4);
      texel[2] = tone;
      texel[3] = 255;
    }
  return image;
}

// A white square for the sun and a dimmer, blotched one for the moon; each fills the middle quarter
// of its half, as in the game.
Image8 celestialImage() {
  Image8 image(64, 32, 4);
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 64; ++x) {
      const float dx = (static_cast<float>(x % 32) - 15.5f) / 4,
                  dy = (static_cast<float>(y) - 15.5f) / 4;
      const bool inside = std::max(std::abs(dx), std::abs(dy)) < 1;
      const bool blotch = mixBits(static_cast<std::uint32_t>(y / 2 * 16 + x / 2)) % 3 == 0;
      const std::array<int, 3> color = x < 32   ? std::array{255, 250, 220}
                                       : blotch ? std::array{150, 155, 170}
                                                : std::array{190, 195, 210};
      for (int c = 0; c < 3; ++c)
        image.at(x, y)[c] = static_cast<std::uint8_t>(inside ? color[c] : 0);
      image.at(x, y)[3] = 255;
    }
  return image;
}

}  // namespace orris
