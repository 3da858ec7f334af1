// Opening what the command line names, to read and to write. A function that returns nothing has reported
// why; what it reported is the exit status (Report::status).
#pragma once

#include <memory>
#include <optional>

#include "app/input/common.h"
#include "app/output/report.h"
#include <orris/core/files/file_source.h>
#include <orris/pack/shader_pack.h>
#include <orris/world/world.h>

namespace orris {

/// The files of a pack.
std::shared_ptr<const FileSource> openPackFiles(const std::string& path, Report& report);

/// What the command line asks of a pack: profile, option file, --set, dimension.
std::optional<LoadRequest> makeLoadRequest(const std::shared_ptr<const FileSource>& files,
                                           const PackOptions& options,
                                           const MacroDefinitions& environment, Report& report);

/// Loads one dimension of a pack.
std::optional<ShaderPack> loadPack(const std::shared_ptr<const FileSource>& files,
                                   const LoadRequest& request, Report& report);

/// A world with --time and --dimension of the command line applied.
std::optional<World> loadScene(const SceneOptions& options, const std::string& dimension,
                               Report& report);

/// The camera that `flag` asks for.
std::optional<Camera> chooseCamera(const World& world, const std::string& request, Report& report, const char* flag = "--camera");

/// Reads a whole file; nullopt: reported.
std::optional<std::string> readWholeFile(const std::string& path, Report& report);

/// Can a file be created at `path`? Nothing is changed there. Asked before long work, so that it is not lost. Otherwise
/// reported.
bool checkWritable(const std::string& path, Report& report);
/// The same for a picture, whose extension must be one that writeImage knows.
bool checkPicturePath(const std::string& path, Report& report);

/// Writes a whole file by way of a temporary one, so that no partial file is ever left; /dev/stdout and
/// /dev/stderr as they are.
bool writeWholeFile(const std::string& path, const std::string& text, Report& report);

}  // namespace orris
