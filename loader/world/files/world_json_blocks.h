// The "blocks" of a world.json: a list of operations, applied in order.
#pragma once

#include <orris/world/files/json_reader.h>
#include <orris/world/files/world_json.h>

namespace orris {

inline constexpr IntegerRange kCellRange{-30000000, 30000000};  ///< of each coordinate of a cell

/// The box of blocks that the root's "origin" and "size" (or "from") give, with the operations of
/// "blocks" applied. nullopt when the box itself is wrong; other errors are in the reader.
std::optional<BlockWorld> readBlocks(JsonReader& reader, const JsonNode& root,
                                     const WorldJson& json);

}  // namespace orris
