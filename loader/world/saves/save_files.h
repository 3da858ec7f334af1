// Where the parts of a save lie on disk.
#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

namespace orris {

/// The regions of one dimension of a save.
struct SaveFiles {
  std::filesystem::path root;    ///< what was named: messages and links are judged by it
  std::filesystem::path level;   ///< level.dat; empty when there is none
  std::filesystem::path region;  ///< the folder of the region files
  std::string dimension;         ///< "minecraft:the_nether"
  std::string name;              ///< of the folder or file
  std::map<std::pair<int, int>, std::filesystem::path> regions;  ///< by place x, z
  /// Of entities, beside `region`, where that is below `root`; 1.17 and later.
  std::map<std::pair<int, int>, std::filesystem::path> entityRegions;
};

/// Is `path` a save: a folder with level.dat or with .mca files in it or in `region`, or one such file?
bool isSave(const std::filesystem::path& path);

/// `dimension`: a name with its namespace, "" for the one that the path names, else the overworld.
/// `regions` is empty when the save has none of that dimension.
SaveFiles findSaveFiles(const std::filesystem::path& path, const std::string& dimension);

/// Names of the dimensions that have regions, of a folder with level.dat; sorted.
std::vector<std::string> dimensionsOf(const std::filesystem::path& save);

}  // namespace orris
