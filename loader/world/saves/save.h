// A part of a save as a world: its chunks, its cameras and the frame that level.dat gives.
#pragma once

#include <filesystem>
#include <optional>

#include <orris/world/world.h>

namespace orris {

/// nullopt and an error when nothing of the part can be drawn; chunks that are left out are counted
/// and named in one warning.
std::optional<World> loadSave(const std::filesystem::path& path, const SavePart& part,
                              Diagnostics& diagnostics);

}  // namespace orris
