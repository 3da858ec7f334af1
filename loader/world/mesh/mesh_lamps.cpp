#include <orris/world/mesh/mesh_lamps.h>

#include <array>
#include <set>

namespace orris {

std::vector<MeshLamp> lampsOf(const BlockMesh& mesh) {
  std::vector<MeshLamp> lamps;
  std::set<std::array<int, 3>> cells;
  for (const MeshSection& section : mesh.sections)
    for (std::uint32_t i = 0; i < section.count; i += 4) {
      const MeshFace& face = mesh.faces[(section.first + i) / 4];
      if (face.emission == 0) continue;
      const glm::ivec3 cell = section.origin + glm::ivec3(face.cell);
      if (cells.insert({cell.x, cell.y, cell.z}).second) lamps.push_back({cell, face.emission});
    }
  return lamps;
}

}  // namespace orris
