// What the resource packs of a scene make of its blocks: models, textures and tints. Only what the palette
// uses is read.
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include <orris/world/atlas/block_atlas.h>
#include <orris/world/resources/biome_tint.h>
#include <orris/world/resources/block_model.h>
#include <orris/world/resources/resource_stack.h>

namespace orris {

struct BlockLook {
  std::vector<BlockModel> models;    ///< by palette index; without parts: the facts' own boxes
  std::map<std::string, std::string> flowing;  ///< texture of a still fluid -> of the flowing one
  std::set<std::string> seeThrough;  ///< textures with texels that are not opaque
  BiomeTints tints;
  std::size_t modelled = 0;                 ///< states that have a model
  std::size_t textures = 0;                 ///< that are of the packs
  std::vector<std::string> ownLook;         ///< blocks without a model, by name, sorted
};

/// `facts`, by palette index: those of blocks that only the packs know are replaced. `atlas`: the models' textures
/// and the facts' own. Mistakes in the packs are warnings; the block then keeps its own look.
BlockLook makeBlockLook(const ResourceStack& resources, const World& world,
                        std::vector<BlockFacts>& facts, BlockAtlas& atlas,
                        Diagnostics& diagnostics);

}  // namespace orris
