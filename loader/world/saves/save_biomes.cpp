#include <orris/world/saves/save_biomes.h>

#include <map>

namespace orris {
namespace {

constexpr int kCellsOfSection = kSectionSize / BiomeGrid::kCellBlocks;

class BiomeFiller {
 public:
  explicit BiomeFiller(const BlockWorld& blocks) {
    grid.origin = blocks.origin() >> 2;
    grid.size = ((blocks.origin() + blocks.size() - 1) >> 2) - grid.origin + 1;
    grid.cells.assign(
        std::size_t(grid.size.x) * std::size_t(grid.size.y) * std::size_t(grid.size.z), 0);
  }

  void add(glm::ivec2 chunk, const AnvilSection& section) {
    const glm::ivec3 corner = glm::ivec3(chunk.x, section.y, chunk.y) * kCellsOfSection;
    for (int i = 0; i < kCellsOfSection * kCellsOfSection * kCellsOfSection; ++i) {
      const glm::ivec3 cell = corner + glm::ivec3(i & 3, i >> 4, i >> 2 & 3);
      const glm::ivec3 inside = cell - grid.origin;
      if (inside.x < 0 || inside.y < 0 || inside.z < 0 || inside.x >= grid.size.x ||
          inside.y >= grid.size.y || inside.z >= grid.size.z)
        continue;
      const std::size_t named = section.biomes.size() == 1 ? 0 : std::size_t(i);
      if (named < section.biomes.size())
        grid.cells[grid.cellAt(cell)] = indexOf(section.biomes[named]);
    }
  }

  BiomeGrid grid;
  bool full = false;  ///< there are more names than a cell can tell apart

 private:
  std::uint8_t indexOf(const std::string& name) {
    const auto [entry, fresh] = indices_.try_emplace(name, grid.names.size());
    if (fresh) grid.names.push_back(name);
    full |= entry->second >= BiomeGrid::kMostNames;
    return std::uint8_t(entry->second);
  }

  std::map<std::string, std::size_t> indices_;
};

}  // namespace

std::shared_ptr<const BiomeGrid> biomesOf(const std::vector<PlacedChunk>& chunks,
                                          const BlockWorld& blocks) {
  BiomeFiller filler(blocks);
  for (const PlacedChunk& placed : chunks) {
    if (placed.state != PlacedChunk::State::Read) continue;
    for (const AnvilSection& section : placed.chunk.sections)
      if (!section.biomes.empty()) filler.add(placed.at, section);
  }
  if (filler.grid.names.empty() || filler.full) return nullptr;
  return std::make_shared<const BiomeGrid>(std::move(filler.grid));
}

}  // namespace orris
