// Which folder of program files belongs to which dimension. Contract: idmaps.csv dim.*.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <orris/core/files/file_source.h>
#include <orris/glsl/preprocess/preprocessor.h>

namespace orris {

/// Folders with programs, as pack paths ("/", "/world0").
struct Dimensions {
  std::vector<std::string> folders;             ///< those that hold program files, "/" first
  std::map<std::string, std::string> folderOf;  ///< dimension id -> folder
  std::string base = "/";                       ///< of every other dimension
  bool rootIsRead = true;  ///< some dimension gets the programs directly in shaders/

  /// Those of `folders` that some dimension gets.
  std::vector<std::string> readFolders() const;

  /// The folder for a dimension id ("minecraft:the_nether", "the_nether") or a folder name
  /// ("world-1", "/world-1", "/"); the base folder when nothing is mapped to it.
  std::string resolve(const std::string& dimension) const;
};

/// From dimension.properties, else from the folders world0, world-1 and world1.
Dimensions readDimensions(const FileSource& source, const MacroDefinitions& environment,
                          Diagnostics& diagnostics);

}  // namespace orris
