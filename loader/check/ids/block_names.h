// Names of the game's blocks, for finding misspelt ones in block.properties.
#pragma once

#include <string>
#include <string_view>

namespace orris {

/// The block that `name` (without "minecraft:") is most likely a slip of; "" for blocks of any version of
/// the game and for names that resemble none.
std::string meantBlock(std::string_view name);

}  // namespace orris
