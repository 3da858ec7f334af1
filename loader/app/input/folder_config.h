// The file orris.toml of the working folder, which is read unasked and so may be a stranger's: it chooses
// among the checks of a pack, and names no file.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include <orris/core/diagnostic.h>

namespace orris {

inline constexpr const char* kFolderConfig = "orris.toml";

struct FolderConfig {
  bool present = false;
  std::set<std::string> silenced;  ///< ids that it turns off or gives a severity of its own
};

/// What is allowed in such a file: flags without their dashes.
const std::vector<std::string>& folderConfigKeys();

/// Reads orris.toml of `folder`; `present` is false where there is none. nullopt and diagnostics when it is
/// no regular file of the folder, is too large, or names what only a file given by --config may name.
std::optional<FolderConfig> readFolderConfig(const std::string& folder, Diagnostics& diagnostics);

/// Can the file that --config names be read to its end? A device, pipe or too large file is refused, one below /dev
/// left to its reader, a missing one, too. false: with a diagnostic.
bool isBoundedConfig(const std::string& path, Diagnostics& diagnostics);

}  // namespace orris
