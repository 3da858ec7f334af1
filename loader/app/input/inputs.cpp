#include "app/input/inputs.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <map>
#include <set>
#include <sstream>

#include "app/input/shipped_worlds.h"
#include <orris/core/files/named_file.h>
#include <orris/pack/files/text.h>
#include <orris/world/dimension_look.h>
#include <orris/world/resources/resource_stack.h>

namespace orris {
namespace {

/// Written as the streams they are: beside them is no place for a temporary file.
std::ostream* streamOf(const std::string& path) {
  if (path == "/dev/stdout") return &std::cout;
  return path == "/dev/stderr" ? &std::cerr : nullptr;
}

std::optional<Camera> parseCamera(const std::string& text) {
  std::istringstream stream(text);
  double values[5];
  for (int i = 0; i < 5; ++i) {
    if (i > 0 && stream.get() != ',') return std::nullopt;
    if (!(stream >> values[i]) || !std::isfinite(values[i])) return std::nullopt;
  }
  if (stream.peek() != std::istringstream::traits_type::eof()) return std::nullopt;
  Camera camera;
  camera.name = text;
  camera.position = {values[0], values[1], values[2]};
  camera.yaw = float(values[3]);
  camera.pitch = float(values[4]);
  return camera;
}

}  // namespace

std::shared_ptr<const FileSource> openPackFiles(const std::string& path, Report& report) {
  report.setPack(path);
  Diagnostics diagnostics;
  std::shared_ptr<const FileSource> files = openPack(path, diagnostics);
  report.add(diagnostics);
  return files;
}

std::optional<LoadRequest> makeLoadRequest(const std::shared_ptr<const FileSource>& files,
                                           const PackOptions& options,
                                           const MacroDefinitions& environment, Report& report) {
  Diagnostics diagnostics;
  auto request = makeLoadRequest(files, options, environment, diagnostics);
  report.add(diagnostics);
  return request;
}

std::optional<ShaderPack> loadPack(const std::shared_ptr<const FileSource>& files,
                                   const LoadRequest& request, Report& report) {
  Diagnostics diagnostics;
  std::optional<ShaderPack> pack = loadShaderPack(files, request, diagnostics);
  report.add(diagnostics);
  return pack;
}

std::optional<World> loadScene(const SceneOptions& options, const std::string& dimension,
                               Report& report) {
  const std::string path = findWorld(options.path);
  if (path.empty()) {
    const std::vector<std::string> names = shippedWorldNames();
    const std::string meant = suggest(options.path, names);
    report.error("world-unreadable", "no such file or folder, nor a world that comes with Orris",
                 meant.empty() ? fmt::format("worlds: {}", fmt::join(names, ", ")) : meant,
                 options.path);
    return std::nullopt;
  }
  Diagnostics diagnostics;
  SavePart part = options.part;
  // Other folders of a pack belong to no dimension of a save.
  if (fullDimensionName(dimension).find(':') != std::string::npos) part.dimension = fullDimensionName(dimension);
  std::optional<World> world = loadWorld(path, options.seed, diagnostics, part);
  report.add(diagnostics);
  if (!world) return std::nullopt;
  // What cannot be opened is reported before any work is done.
  const bool opened = openResources(options.resources, diagnostics).has_value();
  report.add(diagnostics);
  if (!opened) return std::nullopt;
  world->resourcePacks = options.resources;
  if (options.time) world->environment.time = *options.time;
  if (const std::string asked = fullDimensionName(dimension); !dimension.empty() && asked != world->environment.dimension)
    setDimension(asked, world->environment);
  return world;
}

std::optional<Camera> chooseCamera(const World& world, const std::string& request, Report& report, const char* flag) {
  if (request.empty() && !world.cameras.empty()) return world.cameras.front();
  if (const Camera* named = world.camera(request)) return *named;
  if (std::optional<Camera> given = parseCamera(request)) return given;
  std::string names;
  for (const Camera& camera : world.cameras) names += (names.empty() ? "" : ", ") + camera.name;
  report.error("camera-unknown",
               fmt::format("{}: \"{}\" is no camera of this world", flag, request),
               fmt::format("use one of {}, or x,y,z,yaw,pitch", names));
  return std::nullopt;
}

std::optional<std::string> readWholeFile(const std::string& path, Report& report) {
  Diagnostics diagnostics;
  std::optional<std::string> text = readNamedFile(path, diagnostics);
  report.add(diagnostics);
  return text;
}

bool checkWritable(const std::string& path, Report& report) {
  Diagnostics diagnostics;
  if (streamOf(path) != nullptr || canWriteNamedFile(path, diagnostics)) return true;
  report.add(diagnostics);
  return false;
}

bool checkPicturePath(const std::string& path, Report& report) {
  static const std::set<std::string> kExtensions = {".png", ".exr", ".hdr", ".pfm", ".tif"};
  if (kExtensions.contains(std::filesystem::path(path).extension())) {
    return checkWritable(path, report);
  }
  report.error("picture-format-unknown", "no picture format has this ending",
               fmt::format("use {}", fmt::join(kExtensions, ", ")), path);
  return false;
}

bool writeWholeFile(const std::string& path, const std::string& text, Report& report) {
  if (std::ostream* stream = streamOf(path)) return bool(*stream << text << std::flush);
  Diagnostics diagnostics;
  if (writeNamedFile(path, text, diagnostics)) return true;
  report.add(diagnostics);
  return false;
}

}  // namespace orris
