// An atlas of textures of several sizes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <orris/core/limits.h>
#include <orris/world/atlas/block_atlas.h>

namespace orris {

struct NamedTile {
  std::string name;
  TileImages images;
  std::optional<TileAnimation> animation{};  ///< frames of the size of `images`
};

/// Each tile lies at a multiple of its size, rounded up to a power of two from 16, so that BlockAtlas::kMipLevels
/// mix no two. Texels of alpha 0 get the tile's mean colour, as those of drawn tiles have. False: the largest were
/// halved until all fit into `mostTexels`.
bool packTiles(std::vector<NamedTile> tiles, BlockAtlas& atlas,
               std::size_t mostTexels = limits::kAtlasTexels);

}  // namespace orris
