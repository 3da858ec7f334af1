// Builds in a file of gzip-compressed tags: Sponge schematics (.schem), versions 1 to 3, with a palette and
// varint indices; and the formats of tag_builds.h, which differ in what they hold.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <orris/core/diagnostic.h>
#include <orris/world/blocks/block_world.h>

namespace orris {

/// The blocks, at origin (0,0,0). `name` is the file's name for diagnostics. Every length and index
/// is checked; nullopt and one error when anything is wrong, never a part of the blocks.
std::optional<BlockWorld> parseSchematic(std::string_view bytes, const std::string& name,
                                         Diagnostics& diagnostics,
                                         std::int64_t maximumBlocks = kMaxWorldBlocks);

/// The same from the decompressed tags.
std::optional<BlockWorld> parseSchematicTags(std::string_view tags, const std::string& name,
                                             Diagnostics& diagnostics,
                                             std::int64_t maximumBlocks = kMaxWorldBlocks);

}  // namespace orris
