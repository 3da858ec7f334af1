// From the mesh of the frame to quads in cells.
#pragma once

#include <vector>

#include <orris/trace/grid/voxel_grid.h>
#include <orris/world/mesh/block_mesh.h>

namespace orris {

/// A drawn face in the cell it belongs to.
struct PlacedQuad {
  glm::ivec3 cell{0};  ///< world blocks
  int face = -1;       ///< FaceDirection of its normal, -1 oblique
  TraceQuad quad;      ///< corner in world blocks
};

TraceTexture linearTexture(const Image8& image);

/// Every quad of the mesh, sorted by cell (y, z, x), then face.
std::vector<PlacedQuad> placeQuads(const BlockMesh& mesh, const BlockAtlas& atlas);

/// Alpha-weighted mean of linear colour, and in w the share that an alpha test leaves.
glm::vec4 meanTexel(const TraceTexture& texture, const TraceQuad& quad);

bool isUnitSide(const PlacedQuad& placed);

}  // namespace orris
