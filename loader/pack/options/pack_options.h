// Which pack a user asks for, and how it is set up.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include <orris/pack/shader_pack.h>
#include <orris/pack/versions/iris_versions.h>

namespace orris {

/// Which pack, and how it is set up.
struct PackOptions {
  std::string path;
  std::string profile;
  OptionValues values;  ///< wins over `settingsFile`, which wins over `profile`
  std::string settingsFile;
  std::string dimension;  ///< "" for the world's own
  HostVersions versions;  ///< of Iris and the game
};

/// The oldest and the newest that a pack is checked for; equal when it is one.
struct VersionRange {
  HostVersions oldest, newest;
};

/// How `options` ask for the pack that `files` hold. nullopt: there is no such dimension, or the settings
/// file cannot be read or applied.
std::optional<LoadRequest> makeLoadRequest(const std::shared_ptr<const FileSource>& files,
                                           const PackOptions& options,
                                           const MacroDefinitions& environment,
                                           Diagnostics& diagnostics);

/// The name of one of the game's dimensions for the folder names and short names that packs use, "world0";
/// other names as they are.
std::string fullDimensionName(const std::string& name);

}  // namespace orris
