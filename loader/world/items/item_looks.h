// What the resource packs make of items.
#pragma once

#include <map>
#include <string>

#include <orris/world/blocks/block_facts.h>
#include <orris/world/resources/block_model.h>
#include <orris/world/resources/look_textures.h>

namespace orris {

/// An item as the packs draw it, in a cube 0..1.
struct ItemLook {
  ModelFaces faces;
  bool flat = false;  ///< of layers of texels, as a sword
};

/// An item that the world shows.
struct ItemUse {
  const BlockFacts* facts = nullptr;  ///< without boxes: no block
  int times = 0;                      ///< how often it is drawn in a frame
};

/// By item; one that is absent keeps the look of Orris. Textures of the faces join `textures`.
std::map<std::string, ItemLook> makeItemLooks(const ResourceStack& resources,
                                              const std::map<std::string, ItemUse>& items,
                                              LookTextures& textures, Diagnostics& diagnostics);

}  // namespace orris
