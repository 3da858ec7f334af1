// One number a cell, 0 to 15, of the sections of a box; those of one number take no memory.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include <orris/world/blocks/block_world.h>

namespace orris {

/// Holds every section that the box touches, whole. Cells are world blocks; those asked for lie in them.
class LevelGrid {
 public:
  LevelGrid(glm::ivec3 origin, glm::ivec3 size)
      : first_(origin >> 4), count_(((origin + size - 1) >> 4) - first_ + 1) {
    sections_.resize(std::size_t(count_.x) * std::size_t(count_.y) * std::size_t(count_.z));
  }

  int at(glm::ivec3 p) const {
    const Section& section = sections_[sectionAt(p)];
    return section.cells.empty() ? section.only : section.cells[cellAt(p)];
  }
  void set(glm::ivec3 p, int level) {
    Section& section = sections_[sectionAt(p)];
    if (section.cells.empty()) section.cells.assign(kSectionBlocks, section.only);
    section.cells[cellAt(p)] = std::uint8_t(level);
  }
  /// All cells of p's section.
  void setSection(glm::ivec3 p, int level) { sections_[sectionAt(p)] = {std::uint8_t(level), {}}; }
  /// The number of all cells of p's section, where it is kept once.
  std::optional<int> uniform(glm::ivec3 p) const {
    const Section& section = sections_[sectionAt(p)];
    if (section.cells.empty()) return section.only;
    return std::nullopt;
  }
  glm::ivec3 firstSection() const { return first_; }
  glm::ivec3 sectionCount() const { return count_; }

 private:
  struct Section {
    std::uint8_t only = 0;
    std::vector<std::uint8_t> cells;
  };
  std::size_t sectionAt(glm::ivec3 p) const {
    const glm::ivec3 q = (p >> 4) - first_;
    return (std::size_t(q.y) * std::size_t(count_.z) + std::size_t(q.z)) * std::size_t(count_.x) +
           std::size_t(q.x);
  }
  static std::size_t cellAt(glm::ivec3 p) {
    return std::size_t((p.y & 15) << 8 | (p.z & 15) << 4 | (p.x & 15));
  }

  glm::ivec3 first_, count_;
  std::vector<Section> sections_;
};

}  // namespace orris
