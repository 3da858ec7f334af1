#include <orris/world/luanti/luanti_columns.h>

#include <fmt/core.h>

#include <algorithm>
#include <atomic>

#include <orris/core/limits.h>
#include <orris/core/parallel.h>
#include <orris/core/printable.h>
#include <orris/world/luanti/map_block.h>
#include <orris/world/luanti/node_blocks.h>
#include <orris/world/saves/block_palette.h>

namespace orris {
namespace {

constexpr int kMostHigh = kMaxWorldSize / kSectionSize;  // map blocks
constexpr std::size_t kBytesAtOnce = std::size_t{32} << 20;
constexpr std::size_t kNameShown = 100;
constexpr std::string_view kUpperDoor = "doors:hidden";

/// A column of the map: what is stored of its map blocks, then what became of them.
struct MapColumn {
  PlacedChunk placed;
  std::vector<glm::ivec3> places;  // ascending
  std::vector<std::string> bytes;  // of these
  LuantiLosses losses;
};

/// Heights that are read: around the sea where the map has something there, else around the middle of what it has.
glm::ivec2 heightsToRead(const std::vector<glm::ivec3>& places) {
  if (places.empty()) return {0, 0};
  std::vector<int> heights;
  for (const glm::ivec3& place : places) heights.push_back(place.y);
  std::sort(heights.begin(), heights.end());
  const int low = heights.front(), high = heights.back() + 1;
  if (high - low <= kMostHigh) return {low, high};
  const auto first = std::lower_bound(heights.begin(), heights.end(), -kMostHigh / 2);
  const bool atSea = first != heights.end() && *first < kMostHigh / 2;
  const int middle = atSea ? 0 : heights[heights.size() / 2];
  const int from = std::clamp(middle - kMostHigh / 2, low, high - kMostHigh);
  return {from, from + kMostHigh};
}

void countUnknown(LuantiLosses& losses, const std::string& kind, std::size_t count) {
  losses.unknownNodes += count;
  const auto known = losses.unknownKinds.find(kind);
  if (known != losses.unknownKinds.end())
    known->second += count;
  else if (losses.unknownKinds.size() < kUnknownKinds)
    losses.unknownKinds.emplace(kind, count);
}

void nameProblem(LuantiLosses& losses, glm::ivec3 place, const std::string& problem) {
  ++losses.unreadable;
  if (losses.problems.size() < kNamedMapBlocks)
    losses.problems.push_back(fmt::format("map block ({}, {}, {}): {}", place.x, place.y, place.z, problem));
}

/// A map block as a section of the column: cells in the order of this host.
class SectionMaker {
 public:
  SectionMaker(const MapBlock& block, StateList& states, LuantiLosses& losses)
      : block_(block), states_(states), losses_(losses) {}

  /// `doors`: cells that may be the upper half of what is below.
  AnvilSection make(std::vector<std::size_t>& doors) {
    AnvilSection section;
    section.cells.resize(kSectionBlocks);
    for (std::size_t i = 0; i < kSectionBlocks; ++i) {
      // Luanti: z, y, x from the slowest; here y, z, x, and z runs south.
      const std::size_t x = i & 15, y = i >> 4 & 15, z = 15 - (i >> 8);
      const std::size_t cell = y << 8 | z << 4 | x;
      const std::string& name = block_.names[block_.nodes[i]];
      section.cells[cell] = stateOf(block_.nodes[i], std::uint8_t(block_.param2[i]));
      if (name == kUpperDoor) doors.push_back(cell);
    }
    for (const auto& [node, count] : unknown_)
      countUnknown(losses_, printable(block_.names[node].substr(0, kNameShown)), count);
    const std::uint16_t first = section.cells.front();
    if (doors.empty() && std::ranges::all_of(section.cells, [&](std::uint16_t cell) { return cell == first; })) {
      section.only = first;
      section.cells.clear();
    }
    return section;
  }

 private:
  std::uint16_t stateOf(std::uint16_t node, std::uint8_t param2) {
    const auto [entry, added] = stateOf_.try_emplace(std::uint32_t(node) << 8 | param2);
    if (added) {
      const auto state = blockOfNode(block_.names[node], param2);
      entry->second = {std::uint16_t(states_.indexOf(state.value_or(BlockState{kUnknownNodeBlock, {}}))), !state};
    }
    if (entry->second.second) ++unknown_[node];
    return entry->second.first;
  }

  const MapBlock& block_;
  StateList& states_;
  LuantiLosses& losses_;
  std::map<std::uint32_t, std::pair<std::uint16_t, bool>> stateOf_;  // by node and param2; unknown?
  std::map<std::uint16_t, std::size_t> unknown_;
};

/// Reads the stored bytes of a column's map blocks as its sections. `left`: bytes that may still be decompressed in all.
class ColumnReader {
 public:
  ColumnReader(MapColumn& column, std::atomic<std::int64_t>& left) : column_(column), left_(left) {}

  void read() {
    std::vector<AnvilSection>& sections = column_.placed.chunk.sections;
    for (std::size_t i = 0; i < column_.bytes.size(); ++i) readOne(column_.places[i], column_.bytes[i]);
    column_.bytes = {};
    if (sections.empty()) return;
    for (const auto& [y, cell] : doors_) closeDoor(y, cell);
    column_.placed.chunk.palette = states_.take();
    column_.placed.state = PlacedChunk::State::Read;
  }

 private:
  void readOne(glm::ivec3 place, const std::string& bytes) {
    if (bytes.empty()) return;  // its problem is named already
    std::string problem;
    std::size_t size = 0;
    const auto block = left_ < 0 ? std::nullopt : parseMapBlock(bytes, problem, size);
    if ((left_ -= std::int64_t(size)) < 0) {
      nameProblem(column_.losses, place, fmt::format("those before it take {} bytes when decompressed", limits::kSaveBytes));
    } else if (!block) {
      nameProblem(column_.losses, place, problem);
    } else {
      std::vector<std::size_t> doors;
      column_.placed.chunk.sections.push_back(SectionMaker(*block, states_, column_.losses).make(doors));
      column_.placed.chunk.sections.back().y = place.y;
      for (const std::size_t cell : doors) doors_.emplace_back(place.y, cell);
    }
  }

  /// Above the lower half of a door stands a node without a look.
  void closeDoor(int y, std::size_t cell) {
    const bool lowest = cell < kSectionSize * kSectionSize;
    const auto below = find(lowest ? y - 1 : y);
    const auto own = find(y);
    if (!below || !own || below->cells.empty()) return;
    const std::size_t under = lowest ? cell + kSectionBlocks - kSectionSize * kSectionSize
                                     : cell - kSectionSize * kSectionSize;
    BlockState door = states_.states()[below->cells[under]];
    if (!door.name.ends_with("_door")) return;
    door.properties["half"] = "upper";
    own->cells[cell] = std::uint16_t(states_.indexOf(door));
  }

  AnvilSection* find(int y) {
    std::vector<AnvilSection>& sections = column_.placed.chunk.sections;
    const auto found = std::ranges::find(sections, y, &AnvilSection::y);
    return found == sections.end() ? nullptr : &*found;
  }

  MapColumn& column_;
  std::atomic<std::int64_t>& left_;
  StateList states_;
  std::vector<std::pair<int, std::size_t>> doors_;
};

void joinLosses(LuantiLosses& all, LuantiLosses&& one) {
  all.unreadable += one.unreadable;
  for (std::string& problem : one.problems) {
    if (all.problems.size() < kNamedMapBlocks) all.problems.push_back(std::move(problem));
  }
  const std::size_t unknown = all.unknownNodes + one.unknownNodes;
  for (const auto& [kind, count] : one.unknownKinds) countUnknown(all, kind, count);
  all.unknownNodes = unknown;
}

std::vector<MapColumn> columnsOf(const std::vector<glm::ivec3>& places, glm::ivec2 heights) {
  std::map<std::pair<int, int>, std::vector<glm::ivec3>> byColumn;
  for (const glm::ivec3& place : places) {
    if (place.y >= heights.x && place.y < heights.y) byColumn[{place.z, place.x}].push_back(place);
  }
  std::vector<MapColumn> columns;
  for (auto& [at, held] : byColumn) {
    std::ranges::sort(held, {}, &glm::ivec3::y);
    // Not std::ranges::unique, which clang 14 cannot compile.
    held.erase(std::unique(held.begin(), held.end(), [](const auto& a, const auto& b) { return a.y == b.y; }), held.end());
    MapColumn& column = columns.emplace_back();
    column.placed.at = {at.second, mirroredZ(at.first)};
    column.placed.state = PlacedChunk::State::Unreadable;
    column.places = std::move(held);
  }
  return columns;
}

}  // namespace

std::vector<PlacedChunk> readColumns(MapDatabase& database, glm::ivec2 middle, int radius, LuantiLosses& losses) {
  std::vector<glm::ivec3> places;
  for (int z = middle.y - radius; z <= middle.y + radius; ++z) {
    std::string problem;
    if (!database.addRow(z, middle.x - radius, middle.x + radius, places, problem))
      nameProblem(losses, {middle.x, 0, z}, problem);
  }
  std::vector<MapColumn> columns = columnsOf(places, heightsToRead(places));
  losses.columns = std::size_t(2 * radius + 1) * std::size_t(2 * radius + 1);
  losses.absentColumns = losses.columns - columns.size();

  std::vector<PlacedChunk> chunks;
  std::atomic<std::int64_t> left{std::int64_t(limits::kSaveBytes)};
  for (std::size_t first = 0, last = 0; first < columns.size(); first = last) {
    std::size_t stored = 0;
    for (; last < columns.size() && stored < kBytesAtOnce; ++last) {
      MapColumn& column = columns[last];
      losses.blocks += column.places.size();
      for (const glm::ivec3& place : column.places) {
        std::string problem;
        auto bytes = database.bytesAt(place, problem);
        if (bytes && bytes->empty()) problem = "it is empty";
        if (!problem.empty()) nameProblem(column.losses, place, problem);
        column.bytes.push_back(bytes ? std::move(*bytes) : "");
        stored += column.bytes.back().size();
      }
    }
    const std::size_t from = first;
    forEachInParallel(last - first, [&](std::size_t i) { ColumnReader(columns[from + i], left).read(); });
    for (; first < last; ++first) {
      joinLosses(losses, std::move(columns[first].losses));
      chunks.push_back(std::move(columns[first].placed));
    }
  }
  return chunks;
}

}  // namespace orris
