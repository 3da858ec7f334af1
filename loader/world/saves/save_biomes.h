// The biomes of the chunks of a save.
#pragma once

#include <memory>
#include <vector>

#include <orris/world/blocks/biome_grid.h>
#include <orris/world/blocks/block_world.h>
#include <orris/world/saves/chunk_grid.h>

namespace orris {

/// Of the box of `blocks`; nullptr when no chunk says its biomes (before 1.18), or they have more names than a grid.
/// Where a chunk does not say, the first biome stands.
std::shared_ptr<const BiomeGrid> biomesOf(const std::vector<PlacedChunk>& chunks,
                                          const BlockWorld& blocks);

}  // namespace orris
