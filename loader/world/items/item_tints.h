// Colours that an item gives to parts of its model: dyed leather, the liquid of a bottle, leaves.
#pragma once

#include <glm/glm.hpp>
#include <string>

#include <orris/world/blocks/block_facts.h>
#include <orris/world/files/json_reader.h>

namespace orris {

struct ItemTint {
  glm::u8vec3 color{255};  ///< of an item that nobody has dyed
  bool takesDye = false;   ///< leather, and what a potion has from its brewer
};

/// One of the "tints" of an item's definition. White after a warning, and for sources that are not known.
ItemTint parseItemTint(const JsonNode& node, JsonReader& reader);

/// What the game before 1.21.4 gives to faces of tint index `index` (0 or more): those of a block in the plains, leather,
/// bottles, firework stars, maps; white otherwise.
ItemTint itemTintByName(const std::string& item, const BlockFacts& facts, int index);

}  // namespace orris
