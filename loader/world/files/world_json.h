// The reader of world.json from memory; docs/world-format.md is its specification.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include <orris/world/world.h>

namespace orris {

/// Bytes of a file named in world.json, by its path relative to the folder of world.json;
/// nullopt when it cannot be read.
using WorldFileReader = std::function<std::optional<std::string>(const std::string& path)>;

struct WorldJson {
  std::string_view text;
  std::string file;         ///< for diagnostics
  std::string defaultName;  ///< of a world that gives none
  unsigned seed = 0;        ///< added to the seeds of generated parts
  WorldFileReader readFile;
  std::int64_t maximumBlocks = kMaxWorldBlocks;
};

/// nullopt and at least one located error when anything is wrong: never a part of a world. Errors
/// of syntax and of size end the reading, others are all reported.
std::optional<World> parseWorldJson(const WorldJson& json, Diagnostics& diagnostics);

}  // namespace orris
