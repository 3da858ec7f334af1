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

/// Bytes of a file beside that folder, "/../assets/a.png". nullopt: there is none, or it exceeds the
/// limits.
std::optional<std::string> readBesideInZip(const std::string& zip, std::string_view path,
                                           const PackLimits& limits);

/// The archive can be opened and holds a folder `shaders`.
bool isPackZip(const std::string& path);

}  // namespace orris
