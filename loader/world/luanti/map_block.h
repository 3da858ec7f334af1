// A map block of a Luanti world, as its database keeps it: 16x16x16 nodes by name.
// Luanti: doc/world_format.md
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace orris {

struct MapBlock {
  std::vector<std::string> names;    ///< as stored: any bytes
  std::vector<std::uint16_t> nodes;  ///< index of `names`; x fastest, then y, then z, which runs north
  std::string param2;                ///< a byte for each node
};

/// Of the formats 22 to 29. nullopt, and why not. `size`: bytes that it takes when decompressed.
std::optional<MapBlock> parseMapBlock(std::string_view bytes, std::string& problem, std::size_t& size);

}  // namespace orris
