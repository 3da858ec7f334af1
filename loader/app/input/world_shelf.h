// Worlds near the one that is shown: those of its folder, and those that were shown before.
#pragma once

#include <string>
#include <vector>

namespace orris {

/// Paths of the worlds (a folder with world.json, or a save with level.dat) in the folder that `world` lies
/// in, sorted; empty for a world without a path.
std::vector<std::string> worldsBeside(const std::string& world);

/// The file of recentWorlds(), in a folder of its own, which is made; "" where the user has no home. The answer
/// stays when the environment is gone.
const std::string& recentWorldsFile();

/// Absolute paths of worlds shown before that still exist, the last one first: kept in
/// $XDG_STATE_HOME/orris/recent-worlds, or ~/.local/state without it.
std::vector<std::string> recentWorlds();
/// Puts a world in the first place. What cannot be written is forgotten.
void noteRecentWorld(const std::string& world);

}  // namespace orris
