// The columns of map blocks around a place of a Luanti world, as chunks: x stays, z changes its sign.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <map>
#include <string>
#include <vector>

#include <orris/world/luanti/map_database.h>
#include <orris/world/saves/chunk_grid.h>

namespace orris {

/// What of the part was not read as it is.
struct LuantiLosses {
  std::size_t columns = 0, absentColumns = 0;  ///< asked for, and not in the map
  std::size_t blocks = 0, unreadable = 0;      ///< map blocks of the others
  std::vector<std::string> problems;           ///< of the first that cannot be read, with their places in Luanti
  std::size_t unknownNodes = 0;
  std::map<std::string, std::size_t> unknownKinds;  ///< printable; the first kUnknownKinds
};
constexpr std::size_t kUnknownKinds = 1000, kNamedMapBlocks = 20;

/// The cell of a node, and the node of a cell: the mirror that turns Luanti's north, +z, into ours, -z.
constexpr int mirroredZ(int z) { return -1 - z; }

/// Those of the square of `radius` map blocks around `middle`, a place x, z in Luanti's map blocks.
std::vector<PlacedChunk> readColumns(MapDatabase& database, glm::ivec2 middle, int radius, LuantiLosses& losses);

}  // namespace orris
