// A box of blocks by palette. Coordinates are world blocks, x east, y up, z south, as in the game.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <map>
#include <optional>
#include <vector>

#include <orris/world/blocks/block_state.h>

namespace orris {

constexpr int kMaxWorldSize = 512;  ///< blocks an axis
constexpr std::int64_t kMaxWorldBlocks = std::int64_t(1) << 27;
constexpr std::size_t kMaxPalette = 65535;  ///< a vertex names its state in 16 bits
constexpr int kSectionSize = 16;            ///< blocks along an edge of a section
constexpr std::size_t kSectionBlocks = std::size_t(kSectionSize) * kSectionSize * kSectionSize;

/// The lowest cell of the section that `p` lies in; sections lie at multiples of 16.
inline glm::ivec3 sectionOrigin(glm::ivec3 p) {
  return {p.x & ~(kSectionSize - 1), p.y & ~(kSectionSize - 1), p.z & ~(kSectionSize - 1)};
}

/// Palette entry 0 is always minecraft:air; outside the box everything is air. Stored by sections,
/// and one of a single state takes no memory: most of a world is air or stone.
class BlockWorld {
 public:
  BlockWorld() : BlockWorld(glm::ivec3(0), glm::ivec3(0)) {}
  BlockWorld(glm::ivec3 origin, glm::ivec3 size);

  glm::ivec3 origin() const { return origin_; }
  glm::ivec3 size() const { return size_; }
  bool contains(glm::ivec3 p) const {
    const glm::ivec3 q = p - origin_;
    return unsigned(q.x) < unsigned(size_.x) && unsigned(q.y) < unsigned(size_.y) &&
           unsigned(q.z) < unsigned(size_.z);
  }
  /// Palette index at `p`; 0 outside.
  std::uint32_t indexAt(glm::ivec3 p) const {
    if (!contains(p)) return 0;
    const Section& section = sections_[sectionAt(p)];
    return section.cells.empty() ? section.only : section.cells[cellAt(p)];
  }
  const BlockState& at(glm::ivec3 p) const { return palette_[indexAt(p)]; }
  /// Index of `state`, added when new.
  std::uint32_t paletteIndex(const BlockState& state);
  const std::vector<BlockState>& palette() const { return palette_; }
  /// Ignored outside the box.
  void set(glm::ivec3 p, std::uint32_t paletteIndex);
  void fill(glm::ivec3 from, glm::ivec3 to, std::uint32_t paletteIndex);  ///< both inclusive

  /// The palette index of all cells of p's section, where they are known to have the same one. Of a
  /// section that reaches out of the box: of its cells in the box. 0 for sections outside.
  std::optional<std::uint32_t> uniformSection(glm::ivec3 p) const;
  /// All cells of the section at `origin`, which lies in the box: x runs fastest, then z, then y.
  void setSection(glm::ivec3 origin, std::vector<std::uint16_t> cells);

 private:
  struct Section {
    std::uint16_t only = 0;            // where `cells` is empty: the index of all
    std::vector<std::uint16_t> cells;  // x fastest, then z, then y
  };
  void fillInSection(glm::ivec3 low, glm::ivec3 high, std::uint32_t paletteIndex);
  std::size_t sectionAt(glm::ivec3 p) const {
    const glm::ivec3 q = (p >> 4) - firstSection_;
    return (std::size_t(q.y) * std::size_t(sectionCount_.z) + std::size_t(q.z)) *
               std::size_t(sectionCount_.x) +
           std::size_t(q.x);
  }
  static std::size_t cellAt(glm::ivec3 p) {
    return std::size_t((p.y & 15) << 8 | (p.z & 15) << 4 | (p.x & 15));
  }

  glm::ivec3 origin_, size_;
  glm::ivec3 firstSection_, sectionCount_;  // in sections
  std::vector<BlockState> palette_;
  std::map<BlockState, std::uint32_t> indexOf_;
  std::vector<Section> sections_;
};

}  // namespace orris
