// Hills, water and trees from a seed.
#pragma once

#include <orris/world/blocks/block_world.h>

namespace orris {

struct TerrainSettings {
  unsigned seed = 1;
  int seaLevel = 63;     ///< y of the highest water block, within the box; the default is the game's
  int relief = 14;       ///< heights vary by about this much above and below the sea level
  double trees = 0.5;    ///< share of the 7x7 plots on grass that carry a tree
  double plants = 0.06;  ///< share of grass blocks with a flower or fern
};

/// Fills the whole box. The same settings and box give the same blocks on every machine: only
/// integers, additions and multiplications are used.
void generateTerrain(BlockWorld& world, const TerrainSettings& settings);

}  // namespace orris
