// Which biome a place of a save has.
#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace orris {

/// Cells of 4x4x4 blocks, as the game stores them.
struct BiomeGrid {
  static constexpr int kCellBlocks = 4;
  static constexpr std::size_t kMostNames = 256;
  glm::ivec3 origin{0}, size{0};    ///< in cells; the size is above 0
  std::vector<std::string> names;   ///< with namespace
  std::vector<std::uint8_t> cells;  ///< indices into names; x fastest, then z, then y

  std::size_t cellAt(glm::ivec3 cell) const {
    const glm::ivec3 q = cell - origin;
    return (std::size_t(q.y) * std::size_t(size.z) + std::size_t(q.z)) * std::size_t(size.x) +
           std::size_t(q.x);
  }
  /// Of a block; outside of the grid that of the nearest cell.
  std::uint8_t at(glm::ivec3 block) const {
    return cells[cellAt(glm::clamp(block >> 2, origin, origin + size - 1))];
  }
};

}  // namespace orris
