// A part of a Luanti world as a world: blocks that are like its nodes, cameras, the time of the day.
#pragma once

#include <filesystem>
#include <optional>

#include <orris/world/world.h>

namespace orris {

/// `part.at` is a place as Luanti shows it, where z runs north; the world's z runs south. nullopt and an error when nothing of
/// the part can be drawn; what is left out or unknown is counted and named in a warning each.
std::optional<World> loadLuantiWorld(const std::filesystem::path& path, const SavePart& part, Diagnostics& diagnostics);

}  // namespace orris
