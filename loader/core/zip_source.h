// The files of a zipped shader pack. libzip stays inside the .cpp.
#pragma once

#include <map>
#include <memory>
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

/// The files of an archive below `folder` ("/assets", at the top or the first one of that name), read when they are
/// asked for; none when it has no such folder. What reads more than the limits allow gets nothing.
/// nullptr and a diagnostic when the archive cannot be opened or has too many files.
std::unique_ptr<FileSource> openZipBelow(const std::string& path, const std::string& folder,
                                         const PackLimits& limits, Diagnostics& diagnostics);

/// The archive can be opened and holds a folder `shaders`.
bool isPackZip(const std::string& path);

}  // namespace orris
