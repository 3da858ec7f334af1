// Faces of a world with the attributes Iris gives its terrain. Contract: attributes.csv.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "world/atlas/block_atlas.h"
#include "world/blocks/block_facts.h"
#include "world/mesh/light.h"
#include "world/world.h"

namespace orris {

struct BlockLook;

/// One vertex; quads are four in a row, counter-clockwise seen from outside, (0,1,2)(2,3,0).
struct BlockVertex {
  glm::vec3 position;   ///< relative to the section's origin, blocks
  glm::vec2 uv, midUv;  ///< atlas
  glm::vec3 normal;
  glm::vec4 tangent;     ///< u direction, w handedness
  glm::u8vec4 tint;      ///< biome tint rgb; a: vanilla ambient occlusion 0..255 (255 = none)
  glm::u8vec2 light;     ///< block*16, sky*16 (0..240), smooth
  glm::i8vec4 midBlock;  ///< 1/64 block to the block's centre; w emission 0..15
  std::uint16_t state;   ///< palette index, for mc_Entity
  std::uint16_t fluid;   ///< 1 for fluids (mc_Entity.y)
};

/// Faces of one 16^3 section in one layer, of block entities those of one state: vertices
/// [first, first+count).
struct MeshSection {
  glm::ivec3 origin;
  RenderLayer layer;
  std::uint32_t first = 0, count = 0;
  std::uint16_t state = 0;  ///< block entities: the palette index of all its faces
};

struct BlockMesh {
  std::vector<BlockVertex> vertices;
  std::vector<MeshSection> sections;  ///< sorted by layer, then origin
};

struct MeshInput {
  const BlockWorld& blocks;
  const std::vector<BlockFacts>& facts;  ///< by palette index
  const LightLevels& light;
  const BlockAtlas& atlas;
  float ambientOcclusionLevel = 1;
  const BlockLook* look = nullptr;  ///< of resource packs
};

/// Faces between opaque neighbours are culled. Deterministic order.
BlockMesh buildMesh(const MeshInput& input);

/// One warning for each name of a block without facts.
void warnOfUnknown(const BlockWorld& blocks, const std::vector<BlockFacts>& facts,
                   Diagnostics& diagnostics);
/// Facts by palette index; one warning per unknown block name is appended.
std::vector<BlockFacts> factsOfPalette(const BlockTable& table, const BlockWorld& blocks,
                                       Diagnostics& diagnostics);
/// Texture names used by those facts, sorted, for buildAtlas.
std::vector<std::string> texturesOf(const std::vector<BlockFacts>& facts);

}  // namespace orris
