// Scenes of plain cubes with given albedo and radiance, for which theory has exact answers.
#pragma once

#include <cmath>
#include <map>
#include <tuple>

#include <orris/trace/film/trace_run.h>

namespace orris::test {

struct Cube {
  glm::vec3 albedo{0}, radiance{0};
};

struct BeforeIn {
  bool operator()(const glm::ivec3& a, const glm::ivec3& b) const {
    return std::tie(a.y, a.z, a.x) < std::tie(b.y, b.z, b.x);
  }
};
using Cubes = std::map<glm::ivec3, Cube, BeforeIn>;

/// The shell of a box whose inside is `size` cells, from (1,1,1) on.
inline Cubes roomOf(glm::ivec3 size, const Cube& wall) {
  Cubes cubes;
  for (int y = 0; y <= size.y + 1; ++y)
    for (int z = 0; z <= size.z + 1; ++z)
      for (int x = 0; x <= size.x + 1; ++x) {
        const bool inside = x > 0 && y > 0 && z > 0 && x <= size.x && y <= size.y && z <= size.z;
        if (!inside) cubes[{x, y, z}] = wall;
      }
  return cubes;
}

/// One exposed side of a cube, as the mesher would make it.
inline TraceQuad sideOf(glm::ivec3 cell, int face, const Cube& cube) {
  const glm::vec3 normal(normalOf(FaceDirection(face)));
  const glm::vec3 u = std::abs(normal.x) > 0 ? glm::vec3(0, 0, 1) : glm::vec3(1, 0, 0);
  TraceQuad quad;
  quad.normal = normal;
  quad.edgeU = u;
  quad.edgeV = glm::abs(glm::cross(normal, u));
  quad.corner = glm::vec3(cell) + glm::max(normal, 0.0f);
  quad.uvU = {1, 0};
  quad.tint = cube.albedo;
  return quad;
}

inline TraceTexture whiteTexture() {
  TraceTexture texture{16, 16, {}};
  for (auto& level : texture.levels) level.assign(256, glm::vec4(1));
  return texture;
}

/// Sides that face no other cube; sky and sun as `lighting` says (without options: none).
inline TraceScene sceneOf(const Cubes& cubes, const LightingInput& lighting = {}) {
  glm::ivec3 size(0);
  for (const auto& [cell, cube] : cubes) size = glm::max(size, cell + 1);
  std::vector<std::uint32_t> offsets;
  std::vector<TraceCell> cells;
  std::vector<TraceQuad> quads(1);
  quads[0].tint = glm::vec3(0);
  std::vector<LampFace> lamps;
  for (const auto& [cell, cube] : cubes) {
    TraceCell made;
    made.cube = true;
    made.firstQuad = std::uint32_t(quads.size());
    for (int face = 0; face < 6; ++face) {
      if (cubes.count(cell + normalOf(FaceDirection(face))) != 0) continue;
      TraceQuad quad = sideOf(cell, face, cube);
      if (cube.radiance != glm::vec3(0)) {
        quad.lamp = std::uint32_t(lamps.size());
        LampFace lamp;
        lamp.quad = std::uint32_t(quads.size());
        lamp.corner = quad.corner;
        lamp.edgeU = quad.edgeU;
        lamp.edgeV = quad.edgeV;
        lamp.normal = quad.normal;
        lamp.radiance = cube.radiance;
        lamps.push_back(lamp);
      }
      made.faces = std::uint8_t(made.faces | 1 << face);
      ++made.quadCount;
      quads.push_back(quad);
    }
    offsets.push_back(std::uint32_t(cell.x + size.x * (cell.z + size.z * cell.y)));
    cells.push_back(made);
  }
  TraceScene scene;
  scene.grid = VoxelGrid(size, offsets, std::move(cells), std::move(quads), {{}}, whiteTexture());
  scene.lamps = LampSet(std::move(lamps), size);
  scene.lighting = std::make_shared<PackLighting>(lighting);
  scene.emissionScale.assign(16, 0);
  return scene;
}

/// Mean and its standard error of samples of one number.
struct Estimate {
  double mean = 0, error = 0;
};

template <class Draw>
Estimate estimate(int count, const Draw& draw) {
  double sum = 0, squares = 0;
  for (int i = 0; i < count; ++i) {
    const double x = draw(std::uint32_t(i));
    sum += x;
    squares += x * x;
  }
  const double mean = sum / count;
  return {mean, std::sqrt(std::max(0.0, squares / count - mean * mean) / count)};
}

/// A point on a cube's side from which light is gathered.
inline TraceSurface surfaceOn(glm::ivec3 cell, FaceDirection face, glm::vec2 at) {
  const TraceQuad quad = sideOf(cell, int(face), {});
  TraceSurface surface;
  surface.position = quad.corner + quad.edgeU * at.x + quad.edgeV * at.y;
  surface.normal = quad.normal;
  surface.cell = cell + normalOf(face);
  return surface;
}

}  // namespace orris::test
