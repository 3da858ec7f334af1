// Opening what the command line names, to read and to write. Each function reports its problems and, when it returns
// nothing, sets the exit status: kUsage for what cannot be read or asked for, kProblems for mistakes
// inside a pack.
#pragma once

#include <memory>
#include <optional>

#include "app/input/common.h"
#include "app/report/report.h"
#include "core/file_source.h"
#include "pack/shader_pack.h"
#include "world/world.h"

namespace orris {

/// The files of a pack; nullptr: `status` is set.
std::shared_ptr<const FileSource> openPackFiles(const std::string& path, Report& report,
                                                int& status);

/// What the command line asks of a pack: profile, option file, --set, dimension. nullopt: `status`
/// is set.
std::optional<LoadRequest> makeLoadRequest(const std::shared_ptr<const FileSource>& files,
                                           const PackOptions& options,
                                           const MacroDefinitions& environment, Report& report,
                                           int& status);
/// Why a load failed: kUsage when the pack loads without the chosen options, else kProblems.
int loadFailureStatus(const std::shared_ptr<const FileSource>& files, const LoadRequest& request);

/// Loads one dimension of a pack.
std::optional<ShaderPack> loadPack(const std::shared_ptr<const FileSource>& files,
                                   const LoadRequest& request, Report& report, int& status);

/// A world with --time and --dimension of the command line applied.
std::optional<World> loadScene(const SceneOptions& options, const std::string& dimension,
                               Report& report, int& status);

/// The camera that `flag` asks for. nullopt: `status` is set.
std::optional<Camera> chooseCamera(const World& world, const std::string& request, Report& report,
                                   int& status, const char* flag = "--camera");

/// Reads a whole file; nullopt: reported, `status` is set.
std::optional<std::string> readWholeFile(const std::string& path, Report& report, int& status);

/// The same for a file of a folder, which no link may lead out of.
std::optional<std::string> readWholeFileBelow(const std::string& folder, const std::string& name,
                                              Report& report, int& status);

/// Can a file be created at `path`? Nothing is changed there. Asked before long work, so that it is not lost. Otherwise
/// reported, `status` is set.
bool checkWritable(const std::string& path, Report& report, int& status);
/// The same for a picture, whose extension must be one that writeImage knows.
bool checkPicturePath(const std::string& path, Report& report, int& status);

/// Writes a whole file by way of a temporary one, so that no partial file is ever left; /dev/stdout and
/// /dev/stderr as they are.
bool writeWholeFile(const std::string& path, const std::string& text, Report& report, int& status);

}  // namespace orris
