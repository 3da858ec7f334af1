// What a load reads of a pack and no option value changes: shared by all builds of it.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <orris/core/files/file_source.h>
#include <orris/pack/files/include_graph.h>
#include <orris/pack/options/options.h>
#include <orris/pack/programs/dimensions.h>
#include <orris/pack/properties/shader_properties.h>

namespace orris {

struct PackFiles {
  std::shared_ptr<const FileSource> source;
  Dimensions dimensions;
  std::vector<std::string> entries;  ///< the program files of all folders
  IncludeGraph graph;
  OptionSet options;
  std::vector<std::string> optionNames;   ///< sorted
  std::optional<std::string> properties;  ///< text of shaders.properties
  std::vector<Profile> profiles;
  std::map<std::string, std::map<std::string, std::string>> languages;
  std::set<std::string> broken;  ///< files with an #include in error
  bool complete = true;          ///< false: Iris refuses the pack, for what `diagnostics` hold
};

inline constexpr const char* kPropertiesFile = "/shaders.properties";

/// Reads all folders. `environment` decides dimension.properties. Errors (missing include, cycle, no
/// programs) leave `complete` false; a broken #include then counts as an empty file.
std::shared_ptr<const PackFiles> readPackFiles(std::shared_ptr<const FileSource> source,
                                               const MacroDefinitions& environment,
                                               Diagnostics& diagnostics);

}  // namespace orris
