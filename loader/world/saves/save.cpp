#include <orris/world/saves/save.h>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>

#include <orris/core/add_diagnostic.h>
#include <orris/core/limits.h>
#include <orris/core/printable.h>
#include <orris/core/files/read_file.h>
#include <orris/world/blocks/neighbour_joins.h>
#include <orris/world/dimension_look.h>
#include <orris/world/saves/biome_climate.h>
#include <orris/world/saves/chunk_grid.h>
#include <orris/world/saves/level_data.h>
#include <orris/world/saves/save_biomes.h>
#include <orris/world/saves/save_files.h>
#include <orris/world/standing_camera.h>

namespace orris {
namespace {

constexpr int kBlocksOfChunk = kSectionSize;
constexpr std::size_t kNamedChunks = 20, kNamedKinds = 20;
constexpr double kEyeHeight = 1.62;

/// What level.dat says; a damaged one is a warning.
LevelData readLevel(const SaveFiles& files, Diagnostics& diagnostics) {
  if (files.level.empty()) return {};
  ReadFault fault{};
  const auto bytes = readFileBelow(files.root.string(), files.level.filename().string(),
                                   limits::kChunkBytes, fault);
  std::string problem = describe(fault);
  auto level = bytes ? parseLevelData(*bytes, problem) : std::nullopt;
  if (level) return *level;
  addWarning(diagnostics, "level-unreadable", {files.level.string()},
             fmt::format("{}; the time is noon and nobody has a place", problem),
             "choose a place with --at X,Z; the game keeps an older copy in level.dat_old");
  return {};
}

glm::ivec2 chunkOf(glm::dvec2 place) {
  return glm::ivec2(glm::floor(place / double(kBlocksOfChunk)));
}

/// Where the part lies, and what stands there.
struct SaveSpot {
  glm::dvec2 column{0};              ///< blocks, x and z
  std::optional<SavedPlace> player;  ///< when the part is around the player
};

std::optional<SaveSpot> spotOf(const SaveFiles& files, const LevelData& level,
                               const SavePart& part) {
  if (part.at) return SaveSpot{glm::dvec2(*part.at) + 0.5, std::nullopt};
  if (level.player && level.player->dimension == files.dimension)
    return SaveSpot{{level.player->feet.x, level.player->feet.z}, level.player};
  if (level.spawn && level.spawn->dimension == files.dimension)
    return SaveSpot{{level.spawn->feet.x, level.spawn->feet.z}, std::nullopt};
  const auto middle = middleOfRegions(files);
  if (!middle) return std::nullopt;
  return SaveSpot{(glm::dvec2(*middle) + 0.5) * double(kBlocksOfChunk), std::nullopt};
}

/// Of chunks that are left out: how many of which kind, and the problems of those that are unreadable.
void warnOfChunks(const std::vector<PlacedChunk>& chunks, const SaveFiles& files,
                  Diagnostics& diagnostics) {
  using State = PlacedChunk::State;
  const auto count = [&](State state) {
    return std::size_t(std::count_if(chunks.begin(), chunks.end(),
                                     [&](const PlacedChunk& c) { return c.state == state; }));
  };
  const std::size_t absent = count(State::Absent), unfinished = count(State::Unfinished),
                    unreadable = count(State::Unreadable);
  if (absent + unfinished + unreadable == 0) return;
  std::vector<std::string> kinds;
  if (absent > 0) kinds.push_back(fmt::format("{} that the save does not hold", absent));
  if (unfinished > 0) kinds.push_back(fmt::format("{} that the game has only begun", unfinished));
  if (unreadable > 0) kinds.push_back(fmt::format("{} that cannot be read", unreadable));
  addWarning(diagnostics, "chunks-left-out", {files.region.string()},
             fmt::format("{} of {} chunks are left out: {}", absent + unfinished + unreadable,
                         chunks.size(), fmt::join(kinds, ", ")));
  for (const PlacedChunk& placed : chunks) {
    if (placed.state != State::Unreadable) continue;
    std::vector<std::string>& notes = diagnostics.back().notes;
    if (notes.size() == kNamedChunks) {
      notes.push_back(fmt::format("and {} more", unreadable - kNamedChunks));
      return;
    }
    const std::string version = placed.chunk.dataVersion > 0
                                    ? fmt::format(" (data version {})", placed.chunk.dataVersion)
                                    : "";
    notes.push_back(
        fmt::format("chunk ({}, {}): {}{}", placed.at.x, placed.at.y, placed.problem, version));
  }
}

/// Adds to `world` what the chunks hold besides blocks.
void addThings(SavedThings& things, World& world) {
  const glm::ivec3 low = world.blocks.origin(), end = low + world.blocks.size();
  const auto inside = [&](const glm::dvec3& at) {
    return at.x >= low.x && at.x < end.x && at.z >= low.z && at.z < end.z;
  };
  for (Entity& entity : things.entities) {
    if (inside(entity.position))
      world.content.entities.push_back(std::move(entity));
    else
      ++things.damaged;
  }
  std::vector<BlockText>& texts = world.content.texts;
  for (const SavedSign& sign : things.signs) {
    if (!world.blocks.contains(sign.at)) continue;
    std::vector<BlockText> lines = textsOf(sign, world.blocks.at(sign.at));
    if (texts.size() + lines.size() > limits::kWorldThings)
      ++things.tooFar;
    else
      std::ranges::move(lines, std::back_inserter(texts));
  }
}

/// Of entities and signs that are left out: how many and why.
void warnOfThings(const SavedThings& things, const SaveFiles& files, Diagnostics& diagnostics) {
  std::vector<std::pair<std::size_t, std::string>> kinds;
  std::size_t figureless = 0;
  for (const auto& [kind, count] : things.figureless) {
    figureless += count;
    kinds.emplace_back(count, kind);
  }
  if (figureless + things.tooFar + things.damaged + things.unreadableChunks == 0) return;
  std::vector<std::string> reasons;
  if (figureless > 0) reasons.push_back(fmt::format("{} that no figure shows", figureless));
  if (things.tooFar > 0)
    reasons.push_back(fmt::format("{} behind the {} nearest", things.tooFar, limits::kWorldThings));
  if (things.damaged > 0) reasons.push_back(fmt::format("{} without a sane kind or place", things.damaged));
  if (things.unreadableChunks > 0)
    reasons.push_back(fmt::format("those of {} chunks, which cannot be read", things.unreadableChunks));
  addWarning(diagnostics, "entities-left-out", {files.region.string()},
             fmt::format("entities and signs are left out: {}", fmt::join(reasons, ", ")));
  std::vector<std::string>& notes = diagnostics.back().notes;
  std::ranges::stable_sort(kinds, std::greater(), [](const auto& kind) { return kind.first; });
  for (const auto& [count, kind] : kinds) {
    if (notes.size() == kNamedKinds) {
      notes.push_back(fmt::format("and {} more kinds", kinds.size() - kNamedKinds));
      break;
    }
    notes.push_back(fmt::format("{} {}", count, kind));
  }
  if (!things.problem.empty()) notes.push_back(fmt::format("a chunk of entities: {}", things.problem));
}

void failWithoutRegions(const SaveFiles& files, Diagnostics& diagnostics) {
  const std::vector<std::string> has = dimensionsOf(files.root);
  addError(diagnostics, "world-unreadable", {files.root.string()},
           fmt::format("this save has no region files (r.X.Z.mca) of {}", files.dimension),
           has.empty() ? "name a save of 1.2.1 or newer, a folder of .mca files or one of them"
                       : fmt::format("it has {}", fmt::join(has, ", ")));
}

void failWithoutChunks(const SaveFiles& files, glm::ivec2 middle, int radius,
                       Diagnostics& diagnostics) {
  const auto held = middleOfRegions(files);
  addError(diagnostics, "world-unreadable", {files.region.string()},
           fmt::format("no finished chunk lies within {} chunks of block ({}, {})", radius,
                       middle.x * kBlocksOfChunk + 8, middle.y * kBlocksOfChunk + 8),
           held ? fmt::format("the middle of the save is --at {},{}", held->x * kBlocksOfChunk + 8,
                              held->y * kBlocksOfChunk + 8)
                : "");
}

/// Of the game 1.12 and before?
bool hasNumericIds(const PlacedChunk& placed) {
  constexpr int kFirstWithNames = 1451;
  return placed.state == PlacedChunk::State::Read && placed.chunk.dataVersion < kFirstWithNames;
}

void setEnvironment(const LevelData& level, const std::string& biome, int radius,
                    Environment& environment) {
  environment.time = level.time;
  environment.day = level.day;
  environment.rain = level.rain ? 1 : 0;
  environment.thunder = level.thunder ? 1 : 0;
  environment.renderDistance = std::clamp(radius * kBlocksOfChunk, 16, 1024);
  environment.clouds = Clouds::Fancy;
  if (!biome.empty()) environment.biome = biome;
  const BiomeClimate climate = climateOf(environment.biome);
  environment.temperature = climate.temperature;
  environment.rainfall = climate.rainfall;
}

void setCameras(const SaveSpot& spot, World& world) {
  if (spot.player) {
    const glm::dvec3 eye = spot.player->feet + glm::dvec3(0, kEyeHeight, 0);
    world.cameras.push_back({"player", eye, spot.player->yaw, spot.player->pitch, 70});
  }
  if (auto camera = surfaceCamera(world, glm::ivec2(glm::floor(spot.column))))
    world.cameras.push_back(*camera);
  world.cameras.push_back(outsideCamera(world.blocks, "overview"));
}

}  // namespace

std::optional<World> loadSave(const std::filesystem::path& path, const SavePart& part,
                              Diagnostics& diagnostics) {
  const SaveFiles files = findSaveFiles(path, part.dimension);
  const LevelData level = readLevel(files, diagnostics);
  const int radius = part.radius.value_or(kDefaultSaveRadius);
  const auto spot = files.regions.empty() ? std::nullopt : spotOf(files, level, part);
  if (!spot) {
    failWithoutRegions(files, diagnostics);
    return std::nullopt;
  }
  const glm::ivec2 middle = chunkOf(spot->column);
  SavedThings things;
  std::vector<PlacedChunk> chunks = readChunks(files, middle, radius, things);
  warnOfChunks(chunks, files, diagnostics);
  if (std::none_of(chunks.begin(), chunks.end(),
                   [](const PlacedChunk& c) { return c.state == PlacedChunk::State::Read; })) {
    failWithoutChunks(files, middle, radius, diagnostics);
    return std::nullopt;
  }
  std::string problem;
  auto blocks = joinChunks(chunks, spot->player ? spot->player->feet.y : 64, problem);
  if (!blocks) {
    addError(diagnostics, "world-unreadable", {files.region.string()}, problem);
    return std::nullopt;
  }
  if (std::any_of(chunks.begin(), chunks.end(), hasNumericIds)) {
    completeParts(*blocks);
    joinSides(*blocks);
  }
  World world;
  world.name = level.name.empty() ? files.name : printable(level.name);
  world.exercises = fmt::format(
      "{} chunks of a save", std::count_if(chunks.begin(), chunks.end(), [](const PlacedChunk& c) {
        return c.state == PlacedChunk::State::Read;
      }));
  world.blocks = std::move(*blocks);
  world.biomes = biomesOf(chunks, world.blocks);
  addThings(things, world);
  warnOfThings(things, files, diagnostics);
  setDimension(files.dimension, world.environment);
  setCameras(*spot, world);
  setEnvironment(level, biomeAt(chunks, glm::ivec3(glm::floor(world.cameras.front().position))),
                 radius, world.environment);
  return world;
}

}  // namespace orris
