// Where the parts of a Luanti world lie on disk, and what its small text files say.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace orris {

struct LuantiFiles {
  std::filesystem::path folder, map;  ///< `map`: map.sqlite, which need not be there
  std::string name;
  std::string backend;              ///< of the map; "" where world.mt says none
  int blockSize = 16;               ///< nodes along an edge of a map block
  std::optional<int> time, day;     ///< ticks as here: 0 is six in the morning
};

/// Is `path` a folder with world.mt or map.sqlite, or one of these files?
bool isLuantiWorld(const std::filesystem::path& path);
LuantiFiles findLuantiFiles(const std::filesystem::path& path);

}  // namespace orris
