// Builds that the game and its mods keep as tags: structures (.nbt), Litematica's .litematic, and the
// .schematic of numeric ids.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <orris/world/blocks/block_world.h>
#include <orris/world/files/nbt.h>

namespace orris {

enum class BuildFormat { Sponge, Structure, Litematic, Numeric };

/// By what the root holds; Sponge where it is none of the others.
BuildFormat buildFormatOf(const NbtTag& root);

/// The blocks of a structure, a litematic or a numeric schematic, with their lowest corner at (0,0,0).
/// `maximum`: blocks of the box. Every length and index is checked; nullopt and why not, never a part.
std::optional<BlockWorld> readBuild(const NbtTag& root, BuildFormat format, std::int64_t maximum,
                                    std::string& problem);

}  // namespace orris
