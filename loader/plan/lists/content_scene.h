// What of a world's content does not change from frame to frame: its kinds, its atlas, its items.
#pragma once

#include <map>
#include <string>

#include <orris/plan/schedule/geometry.h>
#include <orris/world/atlas/block_atlas.h>
#include <orris/world/blocks/block_facts.h>
#include <orris/world/items/item_looks.h>
#include <orris/world/world.h>

namespace orris {

struct ContentScene {
  GeometrySet kinds = 0;  ///< that some frame has; weather apart. Nothing else is compiled or drawn
  BlockAtlas atlas;       ///< of entities, particles, cracks and items; empty without these
  std::map<std::string, BlockFacts> items;  ///< by name; an item that is no block has no boxes
  std::map<std::string, ItemLook> looks;    ///< of items that resource packs draw

  /// nullptr: it has the look of Orris.
  const ItemLook* lookOf(const std::string& item) const;
};
/// `resources`: nullptr: the look of Orris. Mistakes in the packs are warnings.
ContentScene buildContent(const World& world, const ResourceStack* resources,
                          Diagnostics& diagnostics);

/// Rain or snow, by biome and strength; none outside of the overworld.
GeometrySet weatherOf(const Environment& environment);

}  // namespace orris
