#include <orris/world/luanti/luanti_world.h>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>

#include <orris/core/add_diagnostic.h>
#include <orris/core/files/read_file.h>
#include <orris/core/limits.h>
#include <orris/core/printable.h>
#include <orris/world/blocks/neighbour_joins.h>
#include <orris/world/dimension_look.h>
#include <orris/world/luanti/luanti_columns.h>
#include <orris/world/luanti/luanti_files.h>
#include <orris/world/standing_camera.h>

namespace orris {
namespace {

constexpr std::size_t kNamedNodes = 20;
constexpr int kSeaLevel = 0;

std::optional<World> noWorld(const std::filesystem::path& file, std::string problem, std::string hint,
                             Diagnostics& diagnostics) {
  addError(diagnostics, "world-unreadable", {file.string()}, std::move(problem), std::move(hint));
  return std::nullopt;
}

/// Why the map cannot be looked for; "" when it can.
std::string refusal(const LuantiFiles& files) {
  if (!files.backend.empty() && files.backend != "sqlite3")
    return fmt::format("the map of this world is kept by {}: expected sqlite3", printable(files.backend));
  if (files.blockSize != kSectionSize)
    return fmt::format("map blocks of this world have {} nodes along an edge: expected {}", files.blockSize, kSectionSize);
  std::error_code error;
  if (!std::filesystem::exists(files.map, error)) return "this world has no map.sqlite";
  if (!liesBelow(files.folder.string(), files.map.string()))
    return fmt::format("map.sqlite {}", describe(ReadFault::Outside));
  if (!std::filesystem::is_regular_file(files.map, error))
    return fmt::format("map.sqlite {}", describe(ReadFault::NoFile));
  return "";
}

/// Games begin near the middle of the map; else the middle of what it holds. In nodes.
std::optional<glm::ivec2> placeToBegin(MapDatabase& database) {
  std::vector<glm::ivec3> atMiddle;
  std::string ignored;
  if (database.addRow(0, 0, 0, atMiddle, ignored) && !atMiddle.empty()) return glm::ivec2(0);
  const std::vector<glm::ivec2> columns = database.firstColumns();
  if (columns.empty()) return std::nullopt;
  glm::dvec2 sum(0);
  for (const glm::ivec2& column : columns) sum += glm::dvec2(column);
  const glm::dvec2 middle = sum / double(columns.size());
  const auto nearest = std::ranges::min_element(
      columns, {}, [&](glm::ivec2 column) { return glm::distance(glm::dvec2(column), middle); });
  return *nearest * kSectionSize + kSectionSize / 2;
}

void warnOfLosses(const LuantiLosses& losses, const std::filesystem::path& file, Diagnostics& diagnostics) {
  if (losses.absentColumns + losses.unreadable > 0) {
    std::vector<std::string> kinds;
    if (losses.absentColumns > 0)
      kinds.push_back(fmt::format("{} of {} columns that the map does not hold", losses.absentColumns, losses.columns));
    if (losses.unreadable > 0)
      kinds.push_back(fmt::format("{} of {} map blocks that cannot be read", losses.unreadable, losses.blocks));
    addWarning(diagnostics, "chunks-left-out", {file.string()},
               fmt::format("left out: {}", fmt::join(kinds, ", ")));
    diagnostics.back().notes = losses.problems;
    if (losses.unreadable > losses.problems.size())
      diagnostics.back().notes.push_back(fmt::format("and {} more", losses.unreadable - losses.problems.size()));
  }
  if (losses.unknownNodes == 0) return;
  std::vector<std::pair<std::size_t, std::string>> kinds;
  for (const auto& [kind, count] : losses.unknownKinds) kinds.emplace_back(count, kind);
  std::ranges::stable_sort(kinds, std::greater(), [](const auto& kind) { return kind.first; });
  const bool cut = kinds.size() == kUnknownKinds;
  addWarning(diagnostics, "nodes-unknown", {file.string()},
             fmt::format("{} nodes of {}{} kinds are drawn as plain cubes, most often {}", losses.unknownNodes,
                         cut ? "at least " : "", kinds.size(), kinds.front().second));
  for (const auto& [count, kind] : kinds) {
    std::vector<std::string>& notes = diagnostics.back().notes;
    if (notes.size() == kNamedNodes) {
      notes.push_back(fmt::format("and {} more kinds", kinds.size() - kNamedNodes));
      break;
    }
    notes.push_back(fmt::format("{} {}", count, kind));
  }
}

}  // namespace

std::optional<World> loadLuantiWorld(const std::filesystem::path& path, const SavePart& part, Diagnostics& diagnostics) {
  const LuantiFiles files = findLuantiFiles(path);
  if (std::string why = refusal(files); !why.empty()) return noWorld(files.map, std::move(why), "", diagnostics);
  std::string problem;
  const auto database = MapDatabase::open(files.map.string(), problem);
  if (!database) return noWorld(files.map, problem, "name the folder of a world of Luanti, or its map.sqlite", diagnostics);
  const auto place = part.at ? part.at : placeToBegin(*database);
  if (!place) return noWorld(files.map, "this world has no map blocks", "", diagnostics);

  const int radius = part.radius.value_or(kDefaultSaveRadius);
  LuantiLosses losses;
  std::vector<PlacedChunk> chunks =
      readColumns(*database, glm::ivec2(place->x >> 4, place->y >> 4), radius, losses);
  warnOfLosses(losses, files.map, diagnostics);
  const auto read = std::ranges::count(chunks, PlacedChunk::State::Read, &PlacedChunk::state);
  if (read == 0) {
    const auto held = placeToBegin(*database);
    return noWorld(files.map,
                   fmt::format("nothing that can be drawn lies within {} map blocks of node ({}, {})", radius, place->x,
                               place->y),
                   held ? fmt::format("the middle of the map is --at {},{}", held->x, held->y) : "", diagnostics);
  }
  auto blocks = joinChunks(chunks, kSeaLevel, problem);
  if (!blocks) return noWorld(files.map, problem, "", diagnostics);
  joinSides(*blocks);

  World world;
  world.name = printable(files.name);
  world.exercises = fmt::format("{} columns of a Luanti world", read);
  world.blocks = std::move(*blocks);
  world.environment.time = files.time.value_or(world.environment.time);
  world.environment.day = files.day.value_or(world.environment.day);
  world.environment.renderDistance = std::clamp(radius * kSectionSize, 16, 1024);
  world.environment.clouds = Clouds::Fancy;
  if (!part.dimension.empty()) setDimension(part.dimension, world.environment);
  if (auto camera = surfaceCamera(world, {place->x, mirroredZ(place->y)})) world.cameras.push_back(*camera);
  world.cameras.push_back(outsideCamera(world.blocks, "overview"));
  return world;
}

}  // namespace orris
