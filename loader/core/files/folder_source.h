// The files below a folder on the disk.
#pragma once

#include <memory>
#include <string>

#include <orris/core/files/file_source.h>

namespace orris {

/// All files below `root`, which exists; `pack` is the folder that holds it, whose other files readResource()
/// finds, or "". nullptr and a diagnostic when a limit is passed or a folder cannot be listed.
std::unique_ptr<FileSource> openFolder(const std::string& root, const std::string& pack,
                                       const PackLimits& limits, Diagnostics& diagnostics);

}  // namespace orris
