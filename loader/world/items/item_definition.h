// Which model an item has: its file in `items`, of the game since 1.21.4.
#pragma once

#include <optional>
#include <string>

#include <orris/world/resources/resource_stack.h>

namespace orris {

/// The model of an item that nobody uses: of conditions and choices what they are otherwise. nullopt: the item is
/// drawn by code of the game, or (warnings) the file says nothing of use.
std::optional<std::string> parseItemDefinition(const ResourceFile& file, Diagnostics& diagnostics);

}  // namespace orris
