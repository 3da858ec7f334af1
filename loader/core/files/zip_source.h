// The files of a zipped shader pack. libzip stays inside the .cpp.
#pragma once

#include <memory>
#include <string>

#include <orris/core/files/file_source.h>

namespace orris {

/// The files under the archive's `shaders` folder (at the top, else the first folder of that name), read
/// when they are asked for; readResource() knows those beside it, too. Every file is tried once: nullptr and a
/// diagnostic when the archive cannot be read in full or exceeds the limits.
std::unique_ptr<FileSource> openPackZip(const std::string& path, const PackLimits& limits,
                                        Diagnostics& diagnostics);

/// The files of an archive below `folder` ("/assets", at the top or the first one of that name), read when they are
/// asked for; none when it has no such folder. What reads more than the limits allow gets nothing.
/// nullptr and a diagnostic when the archive cannot be opened or has too many files.
std::unique_ptr<FileSource> openZipBelow(const std::string& path, const std::string& folder,
                                         const PackLimits& limits, Diagnostics& diagnostics);

/// The archive can be opened and holds a folder `shaders`.
bool isPackZip(const std::string& path);

}  // namespace orris
