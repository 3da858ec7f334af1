// The block names of the game, by version. What a pack's id maps name may be of an older or newer
// game; what is of none is misspelt, or of a mod that took the game's namespace.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <orris/pack/versions/iris_versions.h>

namespace orris {

struct BlockLife {
  Version since;                 ///< 1.12 stands for that version and all before
  std::optional<Version> until;  ///< the first version without it
  bool existsIn(const Version& game) const { return since <= game && (!until || game < *until); }
};

/// By the name without "minecraft:"; nullptr when no known version has it.
const BlockLife* findBlockLife(std::string_view name);
/// All names of all versions, sorted, without "minecraft:".
const std::vector<std::string>& allBlockNames();

}  // namespace orris
