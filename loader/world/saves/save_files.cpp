#include <orris/world/saves/save_files.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>

#include <orris/core/limits.h>

namespace orris {
namespace {

namespace fs = std::filesystem;

constexpr const char* kLevel = "level.dat";
constexpr int kFarthestPlace = 60000;  // regions, beyond the border of the game
constexpr const char* kOverworld = "minecraft:overworld";

struct KnownDimension {
  const char* name;
  const char* folder;  ///< of the save; 26.1 moved them to dimensions/minecraft
};
constexpr std::array<KnownDimension, 3> kDimensions = {
    {{kOverworld, "."}, {"minecraft:the_nether", "DIM-1"}, {"minecraft:the_end", "DIM1"}}};

bool isFile(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

/// "r.-1.2.mca": (-1, 2).
std::optional<std::pair<int, int>> placeOfRegion(const std::string& file) {
  std::string_view text = file;
  if (!text.starts_with("r.") || !text.ends_with(".mca")) return std::nullopt;
  text = text.substr(2, text.size() - 6);
  int place[2] = {0, 0};
  for (int i = 0; i < 2; ++i) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), place[i]);
    if (error != std::errc() || place[i] < -kFarthestPlace || place[i] > kFarthestPlace)
      return std::nullopt;
    text.remove_prefix(std::size_t(end - text.data()));
    if (i == 0 && !text.starts_with('.')) return std::nullopt;
    if (i == 0) text.remove_prefix(1);
  }
  if (!text.empty()) return std::nullopt;
  return std::pair(place[0], place[1]);
}

std::map<std::pair<int, int>, fs::path> regionsIn(const fs::path& folder) {
  std::map<std::pair<int, int>, fs::path> regions;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    if (regions.size() >= limits::kSaveRegions) break;
    const auto place = placeOfRegion(entry->path().filename().string());
    if (place && isFile(entry->path())) regions.emplace(*place, entry->path());
  }
  return regions;
}

std::map<std::pair<int, int>, fs::path> entitiesBeside(const fs::path& region) {
  return regionsIn(region.parent_path() / "entities");
}

/// Where regions of a dimension may lie, from the folder of level.dat.
std::vector<fs::path> foldersOf(const std::string& dimension) {
  std::vector<fs::path> folders;
  for (const KnownDimension& known : kDimensions) {
    if (dimension == known.name) folders.emplace_back(fs::path(known.folder) / "region");
  }
  const std::size_t colon = dimension.find(':');
  if (colon != std::string::npos && dimension.find("..") == std::string::npos)
    folders.push_back(fs::path("dimensions") / dimension.substr(0, colon) /
                      dimension.substr(colon + 1) / "region");
  return folders;
}

/// What the names of the folders say, from the innermost.
std::string dimensionOfPath(const fs::path& path) {
  std::error_code error;
  fs::path at = fs::weakly_canonical(path, error);
  for (int up = 0; up < 3 && !at.empty(); ++up, at = at.parent_path()) {
    for (const KnownDimension& known : kDimensions) {
      const std::string_view name = known.name;
      if (at.filename() == known.folder || at.filename() == name.substr(name.find(':') + 1))
        return known.name;
    }
  }
  return kOverworld;
}

}  // namespace

bool isSave(const fs::path& path) {
  if (path.extension() == ".mca" || path.filename() == kLevel) return true;
  return isFile(path / kLevel) || !regionsIn(path / "region").empty() || !regionsIn(path).empty();
}

SaveFiles findSaveFiles(const fs::path& path, const std::string& dimension) {
  SaveFiles files;
  const bool isLevel = path.filename() == kLevel && isFile(path);
  files.root = isLevel ? (path.has_parent_path() ? path.parent_path() : fs::path(".")) : path;
  std::error_code error;
  files.name = fs::weakly_canonical(files.root, error).filename().string();
  if (files.root.extension() == ".mca") {
    files.root = path.has_parent_path() ? path.parent_path() : fs::path(".");
    files.region = files.root;
    files.dimension = dimension.empty() ? dimensionOfPath(files.root) : dimension;
    files.regions[placeOfRegion(path.filename().string()).value_or(std::pair(0, 0))] = path;
    return files;
  }
  if (isFile(files.root / kLevel)) {
    files.level = files.root / kLevel;
    files.dimension = dimension.empty() ? kOverworld : dimension;
    for (const fs::path& folder : foldersOf(files.dimension)) {
      files.region = (files.root / folder).lexically_normal();
      files.regions = regionsIn(files.region);
      if (!files.regions.empty()) break;
    }
    files.entityRegions = entitiesBeside(files.region);
    return files;
  }
  files.dimension = dimension.empty() ? dimensionOfPath(files.root) : dimension;
  files.region = files.root / "region";
  files.regions = regionsIn(files.region);
  if (!files.regions.empty()) {
    files.entityRegions = entitiesBeside(files.region);
    return files;
  }
  files.region = files.root;
  files.regions = regionsIn(files.region);
  return files;
}

std::vector<std::string> dimensionsOf(const fs::path& save) {
  std::vector<std::string> names;
  for (const KnownDimension& known : kDimensions) {
    if (!findSaveFiles(save, known.name).regions.empty()) names.emplace_back(known.name);
  }
  return names;
}

}  // namespace orris
