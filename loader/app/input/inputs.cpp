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
#include "core/read_file.h"
#include "core/replace_file.h"
#include "pack/files/text.h"

namespace orris {
namespace {

// A pack that loads without the user's choices but not with them was asked for something wrong.
bool loadsWithoutChoices(const std::shared_ptr<const FileSource>& files, LoadRequest request) {
  Diagnostics ignored;
  request.values.clear();
  request.profile.clear();
  request.buildSources = false;
  return loadShaderPack(files, request, ignored).has_value();
}

std::optional<OptionValues> readSettings(const std::shared_ptr<const FileSource>& files,
                                         const LoadRequest& request, const std::string& path,
                                         Report& report, int& status) {
  const std::optional<std::string> text = readWholeFile(path, report, status);
  if (!text) return std::nullopt;
  Diagnostics diagnostics;
  LoadRequest optionsOnly{.dimension = request.dimension, .environment = request.environment};
  optionsOnly.buildSources = false;
  const std::optional<ShaderPack> pack = loadShaderPack(files, optionsOnly, diagnostics);
  report.add(diagnostics);
  if (!pack) {
    status = kProblems;
    return std::nullopt;
  }
  const OptionValues values = parseOptionFile(path, *text, pack->options, diagnostics);
  report.add(diagnostics);
  return values;
}

// The folder names that packs use for the game's own dimensions.
std::string dimensionName(const std::string& request) {
  static const std::map<std::string, std::string> kNames = {
      {"world0", "minecraft:overworld"},     {"overworld", "minecraft:overworld"},
      {"world-1", "minecraft:the_nether"},   {"the_nether", "minecraft:the_nether"},
      {"world1", "minecraft:the_end"},       {"the_end", "minecraft:the_end"}};
  const auto found = kNames.find(request);
  return found == kNames.end() ? request : found->second;
}

void reportUnwritable(const std::string& path, Report& report, int& status) {
  const std::string problem = outputProblem(path);
  report.error("file-unwritable", problem.empty() ? "cannot be written" : problem,
               "name a file in a folder that exists and may be written", path);
  status = kUsage;
}

void reportUnreadable(const std::string& path, ReadFault fault, Report& report, int& status) {
  report.error("file-unreadable", describe(fault), "", path);
  status = kUsage;
}

/// Written as the streams they are: beside them is no place for a temporary file.
std::ostream* streamOf(const std::string& path) {
  if (path == "/dev/stdout") return &std::cout;
  return path == "/dev/stderr" ? &std::cerr : nullptr;
}

/// A name without a namespace is one of the game's dimensions or a folder of the pack; other mods may add
/// any other.
bool knowsDimension(const FileSource& files, const std::string& request, Report& report,
                    int& status) {
  static const std::vector<std::string> kOfGame = {"overworld", "the_nether", "the_end"};
  constexpr std::string_view kGame = "minecraft:";
  const bool ofGame = request.starts_with(kGame);
  const std::string name = ofGame ? request.substr(kGame.size()) : request;
  const std::string folder = (name.starts_with('/') ? name : "/" + name) + "/";
  const bool known =
      name.empty() || name == "/" || std::ranges::find(kOfGame, name) != kOfGame.end() ||
      name.find(':') != std::string::npos ||
      (!ofGame && (dimensionName(name) != name ||
                   std::ranges::any_of(files.files(), [&](const std::string& file) {
                     return file.starts_with(folder);
                   })));
  if (known) return true;
  const std::string meant = suggest(name, kOfGame);
  report.error("dimension-unknown", fmt::format("--dimension: there is no dimension {}", request),
               meant.empty() ? "name overworld, the_nether, the_end, a folder of the pack (world0), "
                               "or a dimension of a mod with its namespace"
                             : meant);
  status = kUsage;
  return false;
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

std::shared_ptr<const FileSource> openPackFiles(const std::string& path, Report& report,
                                                int& status) {
  report.setPack(path);
  Diagnostics diagnostics;
  std::shared_ptr<const FileSource> files = openPack(path, diagnostics);
  report.add(diagnostics);
  if (!files) status = kUsage;
  return files;
}

std::optional<LoadRequest> makeLoadRequest(const std::shared_ptr<const FileSource>& files,
                                           const PackOptions& options,
                                           const MacroDefinitions& environment, Report& report,
                                           int& status) {
  LoadRequest request{
      .values = options.values, .profile = options.profile, .environment = environment};
  if (!knowsDimension(*files, options.dimension, report, status)) return std::nullopt;
  if (!options.dimension.empty()) request.dimension = options.dimension;
  if (options.settingsFile.empty()) return request;
  const auto values = readSettings(files, request, options.settingsFile, report, status);
  if (!values) return std::nullopt;
  request.fileValues = *values;
  return request;
}

int loadFailureStatus(const std::shared_ptr<const FileSource>& files, const LoadRequest& request) {
  const bool hasChoices =
      !request.values.empty() || !request.fileValues.empty() || !request.profile.empty();
  return hasChoices && loadsWithoutChoices(files, request) ? kUsage : kProblems;
}

std::optional<ShaderPack> loadPack(const std::shared_ptr<const FileSource>& files,
                                   const LoadRequest& request, Report& report, int& status) {
  Diagnostics diagnostics;
  std::optional<ShaderPack> pack = loadShaderPack(files, request, diagnostics);
  report.add(diagnostics);
  if (!pack) status = loadFailureStatus(files, request);
  return pack;
}

std::optional<World> loadScene(const SceneOptions& options, const std::string& dimension,
                               Report& report, int& status) {
  const std::string path = findWorld(options.path);
  if (path.empty()) {
    const std::vector<std::string> names = shippedWorldNames();
    const std::string meant = suggest(options.path, names);
    report.error("world-unreadable", "no such file or folder, nor a world that comes with Orris",
                 meant.empty() ? fmt::format("worlds: {}", fmt::join(names, ", ")) : meant,
                 options.path);
    status = kUsage;
    return std::nullopt;
  }
  Diagnostics diagnostics;
  SavePart part = options.part;
  // Other folders of a pack belong to no dimension of a save.
  if (dimensionName(dimension).find(':') != std::string::npos) part.dimension = dimensionName(dimension);
  std::optional<World> world = loadWorld(path, options.seed, diagnostics, part);
  report.add(diagnostics);
  if (!world) {
    status = kUsage;
    return std::nullopt;
  }
  if (options.time) world->environment.time = *options.time;
  if (!dimension.empty()) world->environment.dimension = dimensionName(dimension);
  return world;
}

std::optional<Camera> chooseCamera(const World& world, const std::string& request, Report& report,
                                   int& status, const char* flag) {
  if (request.empty() && !world.cameras.empty()) return world.cameras.front();
  if (const Camera* named = world.camera(request)) return *named;
  if (std::optional<Camera> given = parseCamera(request)) return given;
  std::string names;
  for (const Camera& camera : world.cameras) names += (names.empty() ? "" : ", ") + camera.name;
  report.error("camera-unknown",
               fmt::format("{}: \"{}\" is no camera of this world", flag, request),
               fmt::format("use one of {}, or x,y,z,yaw,pitch", names));
  status = kUsage;
  return std::nullopt;
}

std::optional<std::string> readWholeFile(const std::string& path, Report& report, int& status) {
  ReadFault fault{};
  std::optional<std::string> text = readFile(path, kMaxTextBytes, fault);
  if (!text) reportUnreadable(path, fault, report, status);
  return text;
}

std::optional<std::string> readWholeFileBelow(const std::string& folder, const std::string& name,
                                              Report& report, int& status) {
  ReadFault fault{};
  std::optional<std::string> text = readFileBelow(folder, name, kMaxTextBytes, fault);
  if (!text) reportUnreadable((std::filesystem::path(folder) / name).string(), fault, report, status);
  return text;
}

bool checkWritable(const std::string& path, Report& report, int& status) {
  if (streamOf(path) != nullptr || outputProblem(path).empty()) return true;
  reportUnwritable(path, report, status);
  return false;
}

bool checkPicturePath(const std::string& path, Report& report, int& status) {
  static const std::set<std::string> kExtensions = {".png", ".exr", ".hdr", ".pfm", ".tif"};
  if (kExtensions.contains(std::filesystem::path(path).extension())) {
    return checkWritable(path, report, status);
  }
  report.error("picture-format-unknown", "no picture format has this ending",
               fmt::format("use {}", fmt::join(kExtensions, ", ")), path);
  status = kUsage;
  return false;
}

bool writeWholeFile(const std::string& path, const std::string& text, Report& report, int& status) {
  if (std::ostream* stream = streamOf(path)) return bool(*stream << text << std::flush);
  if (!replaceFile(path, text)) return true;
  reportUnwritable(path, report, status);
  return false;
}

}  // namespace orris
