// The block atlas: albedo, normal (LabPBR normal+AO+height) and specular (LabPBR) textures, generated
// by our own code, deterministic, 16x16 texels a tile, tiles at multiples of 16.
#pragma once

#include <glm/glm.hpp>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <orris/image/image.h>
#include <orris/world/atlas/tile_animation.h>

namespace orris {

/// Tile rectangle in uv, top row first: (u0,v0) is the tile's top left.
struct AtlasTile {
  glm::vec2 min{0}, max{0};
};

/// Power-of-two size. Default texels: normal (127,127,255,255), specular 0. Empty texels of a tile
/// have its mean colour under alpha 0, so that filtering brings no dark rims.
struct BlockAtlas {
  /// Mipmap levels below the full size that mix no two tiles: level 4 has one texel a tile.
  static constexpr int kMipLevels = 4;
  int tileSize = 16;
  Image8 albedo, normal, specular;
  std::map<std::string, AtlasTile> tiles;
  /// The pictures are those of the first moment; nullptr: none changes.
  std::shared_ptr<const TileAnimations> animations;
  AtlasTile tile(const std::string& name) const;  ///< the "missing" tile when unknown
};

TileImages drawnTile(const std::string& name);

/// The colours of one texture.
Image8 textureImage(const std::string& name);

/// Only the named textures (model no more than the scene needs), plus "missing".
BlockAtlas buildAtlas(const std::vector<std::string>& textureNames);

}  // namespace orris
