#include "world/mesh/mesh_lamps.h"

#include <array>
#include <set>

namespace orris {

std::vector<MeshLamp> lampsOf(const BlockMesh& mesh) {
  std::vector<MeshLamp> lamps;
  std::set<std::array<int, 3>> cells;
  for (const MeshSection& section : mesh.sections)
    for (std::uint32_t i = 0; i < section.count; i += 4) {
      const BlockVertex& vertex = mesh.vertices[section.first + i];
      if (vertex.midBlock.w <= 0) continue;
      const glm::vec3 middle = vertex.position + glm::vec3(vertex.midBlock) / 64.0f;
      const glm::ivec3 cell = section.origin + glm::ivec3(glm::floor(middle));
      if (cells.insert({cell.x, cell.y, cell.z}).second) lamps.push_back({cell, vertex.midBlock.w});
    }
  return lamps;
}

}  // namespace orris
