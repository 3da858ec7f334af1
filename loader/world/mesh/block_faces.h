// The faces of one block state before culling and lighting, with the game's texture coordinates.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <orris/world/atlas/block_atlas.h>
#include <orris/world/blocks/block_facts.h>
#include <orris/world/resources/block_model.h>

namespace orris {

/// A rectangle on a side of the unit cube, along the two axes that are not the side's normal, in
/// ascending order of axis.
struct SideRectangle {
  glm::vec2 low{0}, high{1};
  bool covers(const SideRectangle& other) const;
};

/// How a face is lit: smooth light with ambient occlusion; the light of one cell; or as fluids are,
/// the brighter of its cell and the one above.
enum class FaceShading { Smooth, Flat, Fluid };

/// One quad: corners top left, bottom left, bottom right, top right of its texture as seen from
/// outside, so counter-clockwise.
struct BlockFace {
  std::array<glm::vec3, 4> corners;  ///< 0..1 in the block
  std::array<glm::vec2, 4> uv;       ///< atlas
  glm::vec2 midUv{0};
  glm::vec3 normal{0};
  glm::vec4 tangent{0};
  FaceDirection direction = FaceDirection::Up;
  bool flush = false;   ///< lies on the cube's side `direction`: the cell before it lights it
  std::optional<FaceDirection> cull{};  ///< the neighbour there can hide it
  bool tinted = false;  ///< takes the biome's tint
  int tintIndex = 0;    ///< when tinted: of a model's face
  bool seeThrough = false;  ///< of a model: its texture has holes, so that no solid layer draws it
  FaceShading shading = FaceShading::Smooth;
  bool shade = true;  ///< darkened by its direction, where the pack wants old lighting
  std::uint32_t shape = 0;  ///< set by the mesher: index in BlockMesh::shapes
  SideRectangle side;  ///< when a neighbour can hide it: the part of the side that it covers
};

/// What the mesher needs of one state.
struct BlockFaces {
  std::vector<BlockFace> faces;
  std::array<std::vector<SideRectangle>, 6> covered;  ///< by side, material that reaches it
  bool hidesBehind = false;  ///< `covered` hides what is behind it (solid, not see-through)
};

/// Faces of the boxes or of the cross; none for fluids.
BlockFaces makeBlockFaces(const BlockFacts& facts, const BlockAtlas& atlas);

/// Faces of a resource pack's model. `seeThrough`: textures with holes.
std::vector<BlockFace> makeModelFaces(const std::vector<ModelFace>& faces, bool emits,
                                      const BlockAtlas& atlas,
                                      const std::set<std::string>& seeThrough);

/// Faces of a fluid whose surface is at `height` (0..1). Below 1 the surface has an underside. `flowing`: the texture of
/// its sides, twice as wide as a block; "" for that of the still fluid.
std::vector<BlockFace> makeFluidFaces(const BlockFacts& facts, const BlockAtlas& atlas,
                                      float height, const std::string& flowing);

/// Sixteenths of a turn from east (+x) by south that a surface may flow to.
constexpr std::size_t kFlowHeadings = 16;
/// The surface alone, above and below, as it flows to a heading.
std::vector<BlockFace> makeFlowingSurface(const BlockFacts& facts, const BlockAtlas& atlas,
                                          float height, const std::string& flowing,
                                          std::size_t heading);

/// Index of the two axes along a side.
glm::ivec2 sideAxes(FaceDirection direction);
FaceDirection opposite(FaceDirection direction);

}  // namespace orris
