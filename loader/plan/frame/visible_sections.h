// Which sections of a world can be seen from where the eye is, as caves cannot from above them.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include <orris/world/mesh/section_links.h>

namespace orris {

/// Sections that a line from the eye may reach through what is not opaque, without turning back on any axis. It leaves
/// out none that is seen: a straight line enters and leaves a section only where its open cells join the sides. The game
/// does the same (LevelRenderer, SectionOcclusionGraph).
class VisibleSections {
 public:
  VisibleSections() = default;
  /// `eye` in world blocks, in a cell that is not opaque, in the box of the sections or outside of it.
  VisibleSections(const SectionGrid& grid, const glm::dvec3& eye);

  /// `origin`: of a section of that grid, world blocks.
  bool contains(glm::ivec3 origin) const {
    return seen_[indexOf((origin - origin_) / 16)] != 0;
  }

 private:
  std::size_t indexOf(glm::ivec3 section) const {
    return std::size_t((section.x * size_.y + section.y) * size_.z + section.z);
  }

  glm::ivec3 origin_{0}, size_{0};  ///< of the grid
  /// In the order of its links: bits 1 << FaceDirection of the sides that a line enters by, one more where the eye is.
  std::vector<std::uint8_t> seen_;
};

}  // namespace orris
