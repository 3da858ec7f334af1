// Through which sections one sees into which others.
#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace orris {

/// What is open between the six sides of a section: a line of sight that enters by one leaves by another only if cells
/// that are not opaque join them.
struct SectionLinks {
  static constexpr std::uint8_t kAll = 0x3f;
  /// By FaceDirection of the side of entry: bits 1 << FaceDirection of the sides of leaving.
  std::array<std::uint8_t, 6> from{kAll, kAll, kAll, kAll, kAll, kAll};
  bool operator==(const SectionLinks&) const = default;
};

/// Opaque cells of a section, x fastest, then z, then y: indexOfCell().
using OpaqueCells = std::bitset<16 * 16 * 16>;
constexpr std::size_t indexOfCell(glm::ivec3 cell) { return std::size_t((cell.y * 16 + cell.z) * 16 + cell.x); }

/// Fewer opaque cells than a wall has leave all sides linked without a look.
SectionLinks linksOf(const OpaqueCells& opaque);

/// The sections of a world.
struct SectionGrid {
  glm::ivec3 origin{0};  ///< the lowest cell of the first section
  glm::ivec3 size{0};    ///< sections
  std::vector<SectionLinks> links;  ///< z fastest, then y, then x
};

}  // namespace orris
