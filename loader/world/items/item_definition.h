// Which model an item has, and the colours of its parts: its file in `items`, of the game since 1.21.4.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include <orris/world/items/item_tints.h>
#include <orris/world/resources/resource_stack.h>

namespace orris {

struct ItemDefinition {
  std::string model;
  std::vector<ItemTint> tints;  ///< by tint index; those beyond are white
};

/// Those of an item that nobody uses: of conditions and choices what they are otherwise. nullopt: the item is drawn by
/// code of the game, or (warnings) the file says nothing of use.
std::optional<ItemDefinition> parseItemDefinition(const ResourceFile& file,
                                                  Diagnostics& diagnostics);

}  // namespace orris
