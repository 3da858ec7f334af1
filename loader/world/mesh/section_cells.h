// The states of one section and of the cells around it, read once: faces ask for each many times.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>

#include <orris/world/blocks/block_world.h>

namespace orris {

class SectionCells {
 public:
  /// `origin` is a section's; cells outside of the world are air.
  SectionCells(const BlockWorld& blocks, glm::ivec3 origin);

  /// Palette index; `p` lies in the section or beside it, across an edge or corner, too.
  std::uint32_t at(glm::ivec3 p) const { return states_[cellAt(p - origin_)]; }

 private:
  static constexpr int kSide = kSectionSize + 2;
  static std::size_t cellAt(glm::ivec3 q) {
    return std::size_t(((q.y + 1) * kSide + q.z + 1) * kSide + q.x + 1);
  }

  glm::ivec3 origin_;
  std::array<std::uint16_t, kSide * kSide * kSide> states_{};
};

}  // namespace orris
