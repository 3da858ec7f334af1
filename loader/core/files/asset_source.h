// The files of a resource pack: what lies below its folder `assets`.
#pragma once

#include <memory>
#include <string>

#include <orris/core/files/file_source.h>

namespace orris {

/// Opens a resource pack: a folder that holds `assets` (or is named so), a zip, or the game's own jar. Paths
/// start below `assets`: "/minecraft/models/block/stone.json". Limits: 64 MiB a file, 4 GiB in all, 262144
/// files. nullptr and a diagnostic when it cannot be opened or has no such folder.
std::unique_ptr<FileSource> openAssets(const std::string& path, Diagnostics& diagnostics);

}  // namespace orris
