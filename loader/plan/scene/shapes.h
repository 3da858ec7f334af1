// Shapes that every frame may need: quads, the sky's disc, stars, sun and moon. No GL.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include <orris/image/image.h>
#include <orris/plan/scene/gpu_vertex.h>

namespace orris {

/// A range of triangles: `quads` quads from vertex `firstVertex` of one buffer.
struct QuadRange {
  unsigned firstVertex = 0, quads = 0;
};

/// Collects quads and remembers where each shape starts.
class ShapeList {
 public:
  void quad(const std::array<glm::vec3, 4>& corners, const std::array<glm::vec2, 4>& uv);
  QuadRange since(size_t start) const;
  std::vector<GpuVertex> vertices;
};

inline constexpr std::array<glm::vec2, 4> kUnitUv = {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};

/// A hash of 32 bits whose every bit depends on every bit of `x`.
std::uint32_t mixBits(std::uint32_t x);

/// Shapes around the eye, as the game makes them.
/// Iris: HorizonRenderer. A prism around the eye between two planes, where the game without shaders
/// shows the clear colour: gbuffers_skybasic runs in every direction.
QuadRange addHorizon(ShapeList& shapes);
QuadRange addSkyDisc(ShapeList& shapes);
QuadRange addStars(ShapeList& shapes);
/// A square of half width `size` at height `y`, whose texture starts at `u0`.
QuadRange addCelestialQuad(ShapeList& shapes, float y, float size, float u0);
/// The cube around the eye that is the sky of the End; its texture repeats 16 times a side.
QuadRange addEndCube(ShapeList& shapes);
/// The texture of that cube.
Image8 endSkyImage();
/// Sun in the left half, moon in the right one.
Image8 celestialImage();

}  // namespace orris
