// Colours that an item gives to parts of its model: dyed leather, the liquid of a bottle, leaves.
#pragma once

#include <glm/glm.hpp>
#include <string>

#include <orris/world/blocks/block_facts.h>
#include <orris/world/files/json_reader.h>

namespace orris {

/// One of the "tints" of an item's definition: the colour of an item that nobody has dyed. White after a warning, and
/// for sources that are not known.
glm::u8vec3 parseItemTint(const JsonNode& node, JsonReader& reader);

/// What the game before 1.21.4 gives to faces of tint index `index` (0 or more): those of a block in the plains, leather,
/// bottles, firework stars, maps; white otherwise.
glm::u8vec3 itemTintByName(const std::string& item, const BlockFacts& facts, int index);

}  // namespace orris
