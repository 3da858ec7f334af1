// Faces of a world with the attributes Iris gives its terrain. Contract: attributes.csv.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include <orris/world/atlas/block_atlas.h>
#include <orris/world/blocks/block_facts.h>
#include <orris/world/mesh/light.h>
#include <orris/world/mesh/section_links.h>
#include <orris/world/world.h>

namespace orris {

struct BlockLook;
struct BiomeTints;

/// One vertex of a face; faces have four, counter-clockwise seen from outside, (0,1,2)(2,3,0).
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
  bool shade;            ///< darkened by its direction, where the pack wants old lighting
};

/// Faces of one 16^3 section in one layer, of block entities those of one state: vertices
/// [first, first+count).
struct MeshSection {
  glm::ivec3 origin;
  RenderLayer layer;
  std::uint32_t first = 0, count = 0;
  std::uint16_t state = 0;  ///< block entities: the palette index of all its faces
};

/// What faces of equal blocks share.
struct FaceShape {
  std::array<glm::vec3, 4> corners;  ///< in the block, 0..1
  std::array<glm::vec2, 4> uv;       ///< atlas
  std::array<glm::i8vec3, 4> toMiddle;  ///< 1/64 block to the block's centre
  glm::vec2 midUv;
  glm::vec3 normal;
  glm::vec4 tangent;
  bool shade;
};

/// One face: a save has millions of them, so that each keeps only what is its own.
struct MeshFace {
  std::uint32_t shape;  ///< index in BlockMesh::shapes
  std::uint16_t state;
  std::uint8_t emission, fluid;
  glm::u8vec3 cell;  ///< in the section, 0..15
  glm::u8vec3 tint;
  std::array<std::uint8_t, 4> occlusion;
  std::array<glm::u8vec2, 4> light;
};
static_assert(sizeof(MeshFace) == 28);

struct BlockMesh {
  std::vector<MeshFace> faces;
  std::vector<FaceShape> shapes;
  std::vector<MeshSection> sections;  ///< sorted by layer, then origin
  SectionGrid grid;                   ///< of all sections, those without faces, too

  std::size_t vertexCount() const { return faces.size() * 4; }
  /// The four vertices from `first` on, which is the first of a face.
  std::array<BlockVertex, 4> quad(std::size_t first) const;
};

struct MeshInput {
  const BlockWorld& blocks;
  const std::vector<BlockFacts>& facts;  ///< by palette index
  const LightLevels& light;
  const BlockAtlas& atlas;
  float ambientOcclusionLevel = 1;
  const BlockLook* look = nullptr;    ///< of resource packs
  const BiomeTints* tints = nullptr;  ///< of our own look; nullptr: those of the plains
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
