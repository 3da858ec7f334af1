// Blocks of a mesh that give light.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include <orris/world/mesh/block_mesh.h>

namespace orris {

struct MeshLamp {
  glm::ivec3 cell{0};  ///< world block
  int level = 0;       ///< 1..15
  glm::dvec3 place() const { return glm::dvec3(cell) + 0.5; }
  bool operator==(const MeshLamp&) const = default;
};

/// Each block once, in the order of the mesh.
std::vector<MeshLamp> lampsOf(const BlockMesh& mesh);

}  // namespace orris
