// Which buffer holds which sections of a mesh: drivers take no buffer of more than some gigabytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <orris/world/mesh/block_mesh.h>

namespace orris {

/// Vertices [first, first+count) of the mesh.
struct TerrainPart {
  std::uint32_t first = 0, count = 0;
};

/// Whole sections in their order, as many in a part as have at most `most` vertices together, one at least. A mesh
/// without sections has one part without vertices.
std::vector<TerrainPart> terrainParts(const std::vector<MeshSection>& sections, std::uint32_t most);

/// The index of the part that a section of the mesh lies in.
std::size_t partOf(const std::vector<TerrainPart>& parts, const MeshSection& section);

}  // namespace orris
