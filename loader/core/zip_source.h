// The files of a zipped shader pack. libzip stays inside the .cpp.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "core/file_source.h"

namespace orris {

/// Bytes of every file under the archive's `shaders` folder (at the top, else the first folder of
/// that name), by path below it ("/lib/a.glsl"). nullopt and a diagnostic when the archive cannot be
/// read in full or exceeds the limits.
std::optional<std::map<std::string, std::string>> readZip(const std::string& path,
                                                          const PackLimits& limits,
                                                          Diagnostics& diagnostics);

}  // namespace orris
