#include <orris/world/saves/chunk_grid.h>

#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <limits>

#include <orris/core/limits.h>
#include <orris/core/parallel.h>
#include <orris/core/files/read_file.h>
#include <orris/world/saves/anvil_region.h>

namespace orris {
namespace {

namespace fs = std::filesystem;

/// A file of the save that no link may lead out of.
std::optional<std::string> readSaveFile(const SaveFiles& files, const fs::path& path,
                                        std::size_t limit, std::string& problem) {
  ReadFault fault{};
  auto bytes = readFileBelow(files.root.string(), path.lexically_relative(files.root).string(),
                             limit, fault);
  if (!bytes) problem = fmt::format("{} {}", path.filename().string(), describe(fault));
  return bytes;
}

/// Reads the chunks of one region. `left`: bytes of tags that may still be decompressed in all.
class RegionReader {
 public:
  RegionReader(const SaveFiles& files, glm::ivec2 place, const fs::path& path,
               std::atomic<std::int64_t>& left)
      : files_(files), place_(place), folder_(path.parent_path()), left_(left) {
    const auto bytes = readSaveFile(files, path, limits::kRegionBytes, problem_);
    if (bytes) bytes_ = std::move(*bytes);
  }

  void readBlocks(PlacedChunk& placed) const {
    placed.state = PlacedChunk::State::Unreadable;
    const auto tags = tagsOf(placed.at, placed.problem);
    if (!tags && placed.problem.empty()) placed.state = PlacedChunk::State::Absent;
    if (!tags) return;
    const ChunkOutcome outcome = parseAnvilChunk(*tags, placed.chunk, placed.problem);
    if (outcome == ChunkOutcome::Read) placed.state = PlacedChunk::State::Read;
    if (outcome == ChunkOutcome::Unfinished) placed.state = PlacedChunk::State::Unfinished;
    if (outcome != ChunkOutcome::Read) placed.chunk = {placed.chunk.dataVersion, {}, {}, {}};
  }

  /// Of a region of entities.
  void readThings(glm::ivec2 chunk, SavedThings& things) const {
    std::string problem;
    if (const auto tags = tagsOf(chunk, problem)) {
      readEntityChunk(*tags, things);
    } else if (!problem.empty()) {
      ++things.unreadableChunks;
      things.problem = problem;
    }
  }

 private:
  /// Decompressed. nullopt, and why not, or "" where the region has no such chunk.
  std::optional<std::string> tagsOf(glm::ivec2 chunk, std::string& problem) const {
    const glm::ivec2 inRegion = chunk - place_ * kRegionChunks;
    const AnvilRegion region(bytes_, place_);
    problem = problem_;
    if (!problem.empty() || !region.holds(inRegion)) return std::nullopt;
    auto tags = region.tags(inRegion, [&](glm::ivec2 at) { return external(at); }, problem);
    if (!tags || (left_ -= std::int64_t(tags->size())) >= 0) return tags;
    problem =
        fmt::format("the chunks before it take {} bytes when decompressed", limits::kSaveBytes);
    return std::nullopt;
  }

  std::optional<std::string> external(glm::ivec2 at) const {
    std::string ignored;
    return readSaveFile(files_, folder_ / fmt::format("c.{}.{}.mcc", at.x, at.y),
                        limits::kChunkBytes, ignored);
  }

  const SaveFiles& files_;
  glm::ivec2 place_;
  fs::path folder_;
  std::atomic<std::int64_t>& left_;
  std::string bytes_, problem_;
};

/// The lowest section and the one above the highest that hold a block.
std::optional<glm::ivec2> heightsOf(const std::vector<PlacedChunk>& chunks) {
  int low = std::numeric_limits<int>::max(), high = std::numeric_limits<int>::min();
  for (const PlacedChunk& placed : chunks) {
    for (const AnvilSection& section : placed.chunk.sections) {
      if (section.cells.empty() && section.only == 0) continue;
      low = std::min(low, section.y);
      high = std::max(high, section.y + 1);
    }
  }
  if (low >= high) return std::nullopt;
  return glm::ivec2(low, high);
}

glm::ivec2 nearestHeights(glm::ivec2 heights, double eye) {
  constexpr int kMost = kMaxWorldSize / kSectionSize;
  if (heights.y - heights.x <= kMost) return heights;
  const int low =
      std::clamp(int(std::floor(eye / kSectionSize)) - kMost / 2, heights.x, heights.y - kMost);
  return {low, low + kMost};
}

/// Adds the chunk's states to the world's palette and its sections to the box.
bool placeChunk(PlacedChunk& placed, glm::ivec2 heights, BlockWorld& world) {
  std::vector<std::uint16_t> index;
  for (const BlockState& state : placed.chunk.palette) {
    const std::uint32_t made = world.paletteIndex(state);
    // One more is kept for the water of waterlogged blocks.
    if (made + 1 >= kMaxPalette) return false;
    index.push_back(std::uint16_t(made));
  }
  for (AnvilSection& section : placed.chunk.sections) {
    if (section.y < heights.x || section.y >= heights.y) continue;
    const glm::ivec3 origin = glm::ivec3(placed.at.x, section.y, placed.at.y) * kSectionSize;
    if (section.cells.empty()) {
      world.fill(origin, origin + kSectionSize - 1, index[section.only]);
      continue;
    }
    for (std::uint16_t& cell : section.cells) cell = index[cell];
    world.setSection(origin, std::move(section.cells));
  }
  return true;
}

}  // namespace

std::optional<glm::ivec2> middleOfRegions(const SaveFiles& files) {
  std::vector<glm::ivec2> held;
  glm::dvec2 sum(0);
  double weight = 0;
  for (const auto& [place, path] : files.regions) {
    std::string ignored;
    const auto bytes = readSaveFile(files, path, limits::kRegionBytes, ignored);
    if (!bytes) continue;
    const AnvilRegion region(*bytes, {place.first, place.second});
    for (int i = 0; i < kRegionChunks * kRegionChunks; ++i) {
      const glm::ivec2 inRegion(i % kRegionChunks, i / kRegionChunks);
      if (!region.holds(inRegion)) continue;
      held.push_back(glm::ivec2(place.first, place.second) * kRegionChunks + inRegion);
      const double share = region.sectors(inRegion) - 0.9;  // one sector: hardly begun
      sum += glm::dvec2(held.back()) * share;
      weight += share;
    }
  }
  if (held.empty()) return std::nullopt;
  const glm::dvec2 middle = sum / weight;
  const auto distance = [&](glm::ivec2 at) { return glm::distance(glm::dvec2(at), middle); };
  return *std::min_element(held.begin(), held.end(),
                           [&](glm::ivec2 a, glm::ivec2 b) { return distance(a) < distance(b); });
}

std::vector<PlacedChunk> readChunks(const SaveFiles& files, glm::ivec2 middle, int radius,
                                    SavedThings& things) {
  std::vector<PlacedChunk> chunks;
  std::map<std::pair<int, int>, std::vector<std::size_t>> byRegion;
  for (int z = middle.y - radius; z <= middle.y + radius; ++z) {
    for (int x = middle.x - radius; x <= middle.x + radius; ++x) {
      byRegion[{x >> 5, z >> 5}].push_back(chunks.size());
      chunks.emplace_back().at = {x, z};
    }
  }
  const glm::dvec2 spot = (glm::dvec2(middle) + 0.5) * double(kSectionSize);
  std::atomic<std::int64_t> left{std::int64_t(limits::kSaveBytes)};
  for (const auto& [place, wanted] : byRegion) {
    const auto file = files.regions.find(place);
    if (file == files.regions.end()) continue;
    const RegionReader reader(files, {place.first, place.second}, file->second, left);
    std::optional<RegionReader> entities;
    if (const auto beside = files.entityRegions.find(place); beside != files.entityRegions.end())
      entities.emplace(files, glm::ivec2(place.first, place.second), beside->second, left);
    const std::vector<std::size_t>& inRegion = wanted;  // clang 14 captures no structured binding
    forEachInParallel(inRegion.size(), [&](std::size_t i) {
      PlacedChunk& placed = chunks[inRegion[i]];
      reader.readBlocks(placed);
      if (placed.state != PlacedChunk::State::Read) return;
      if (entities) entities->readThings(placed.at, placed.chunk.things);
      keepNearest(placed.chunk.things, spot);
    });
    for (const std::size_t i : inRegion) {
      join(things, std::move(chunks[i].chunk.things));
      chunks[i].chunk.things = {};
    }
    keepNearest(things, spot);
  }
  return chunks;
}

std::optional<BlockWorld> joinChunks(std::vector<PlacedChunk>& chunks, double eye,
                                     std::string& problem) {
  const auto found = heightsOf(chunks);
  if (!found) {
    problem = "the chunks hold no blocks";
    return std::nullopt;
  }
  const glm::ivec2 heights = nearestHeights(*found, eye);
  glm::ivec2 low(std::numeric_limits<int>::max()), high(std::numeric_limits<int>::min());
  for (const PlacedChunk& placed : chunks) {
    if (placed.state != PlacedChunk::State::Read) continue;
    low = glm::min(low, placed.at);
    high = glm::max(high, placed.at + 1);
  }
  const glm::ivec3 first(low.x, heights.x, low.y), end(high.x, heights.y, high.y);
  BlockWorld world(first * kSectionSize, (end - first) * kSectionSize);
  for (PlacedChunk& placed : chunks) {
    if (placed.state == PlacedChunk::State::Read && !placeChunk(placed, heights, world)) {
      problem = fmt::format("the chunks have more than {} block states", kMaxPalette - 2);
      return std::nullopt;
    }
  }
  return world;
}

std::string biomeAt(const std::vector<PlacedChunk>& chunks, glm::ivec3 cell) {
  const auto placed = std::find_if(chunks.begin(), chunks.end(), [&](const PlacedChunk& candidate) {
    return candidate.at == glm::ivec2(cell.x >> 4, cell.z >> 4);
  });
  if (placed == chunks.end()) return "";
  for (const AnvilSection& section : placed->chunk.sections) {
    if (section.y != cell.y >> 4 || section.biomes.empty()) continue;
    const int part = (cell.y >> 2 & 3) << 4 | (cell.z >> 2 & 3) << 2 | (cell.x >> 2 & 3);
    return section.biomes[section.biomes.size() == 1 ? 0 : std::size_t(part)];
  }
  return "";
}

}  // namespace orris
