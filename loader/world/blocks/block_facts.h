// What the host knows of blocks: shape, emission, opacity, tint, render layer, textures. Two data files,
// blocks.json and shapes.json beside this, compiled into the library.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include <orris/world/blocks/block_state.h>

namespace orris {

/// In the order the game draws them. Only the mesh has BlockEntity: facts say `blockEntity`.
enum class RenderLayer { Solid, Cutout, BlockEntity, Translucent };
inline constexpr int kRenderLayers = 4;
enum class Tint { None, Grass, Foliage, Water };
enum class FaceDirection { Down, Up, North, South, West, East };  // -y +y -z +z -x +x
glm::ivec3 normalOf(FaceDirection direction);

/// A box in 1/16 block inside the unit cube; faces carry texture names.
struct ShapeBox {
  glm::vec3 from{0}, to{16};
  std::string textures[6];       ///< by FaceDirection; "" = no face
  std::uint8_t tintedFaces = 0;  ///< bit 1 << FaceDirection: the face takes the block's tint
};

/// Everything the mesher and the light engine need of one block state.
struct BlockFacts {
  bool air = false;
  bool known = true;  ///< false: drawn with the visible fallback
  bool fluid = false;
  bool cross = false;           ///< two crossed planes with textures[0] of boxes[0]
  bool fullOpaqueCube = false;  ///< hides neighbours' faces, stops light
  bool cullsSame = false;  ///< faces between two of the same block are not drawn (glass, water)
  bool waterlogged = false;
  bool blockEntity = false;  ///< the game draws it apart from the terrain (chests, beds, signs)
  /// Bit 1 << FaceDirection: the boxes cover that side of the cube wholly and opaquely, so it hides
  /// the neighbour's face and lets no light through (the back of stairs, the bottom of a slab).
  std::uint8_t coveredFaces = 0;
  int emission = 0;  ///< 0..15
  int opacity = 0;   ///< light lost per block, 0..15; 15 stops it
  RenderLayer layer = RenderLayer::Solid;
  Tint tint = Tint::None;
  std::vector<ShapeBox> boxes;
};

/// Facts of states, computed once per state.
class BlockTable {
 public:
  BlockTable();
  ~BlockTable();
  BlockFacts factsOf(const BlockState& state) const;
  /// Every texture name that any block of the data file can use, sorted.
  const std::vector<std::string>& textureNames() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace orris
