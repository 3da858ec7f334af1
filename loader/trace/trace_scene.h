// What the path tracer works on: the very quads that the frame draws, in a grid, with the lamps among
// them, the pack's light, and the atlas.
#pragma once

#include <memory>

#include <orris/trace/grid/voxel_grid.h>
#include <orris/trace/light/lamps.h>
#include <orris/trace/light/pack_lighting.h>
#include <orris/world/mesh/block_mesh.h>

namespace orris {

/// What the frame draws.
struct TraceSceneInput {
  const BlockWorld& blocks;
  const std::vector<BlockFacts>& facts;  ///< by palette index
  const std::vector<int>& blockIds;      ///< mc_Entity.x by palette index
  const BlockAtlas& atlas;
  const BlockMesh& mesh;
  LightingInput lighting;
};

struct TraceScene {
  glm::ivec3 origin{0};  ///< of the grid, world blocks
  VoxelGrid grid;
  LampSet lamps;
  std::shared_ptr<const PackLighting> lighting;
  std::vector<float> emissionScale;  ///< by light level 0..15
  std::vector<glm::vec3> stateFilters;  ///< by palette index: what a block's depth of it lets through
};

TraceScene buildTraceScene(const TraceSceneInput& input);

}  // namespace orris
