// Empty space, for leaps: a box of empty cells for every cell and octant of directions.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace orris {

/// By octant (bit axis set: the box extends to higher coordinates from the cell on), then by cell:
/// three lengths of 1 to 31 cells, 0 where the cell is not empty.
using OpenBoxes = std::array<std::vector<std::uint16_t>, 8>;

constexpr int kLongestBox = 31;
constexpr unsigned packBox(int x, int y, int z) { return unsigned(x | y << 5 | z << 10); }
constexpr int boxX(unsigned box) { return int(box & 31); }
constexpr int boxY(unsigned box) { return int(box >> 5 & 31); }
constexpr int boxZ(unsigned box) { return int(box >> 10); }

/// `cells` by offset x + size.x * (z + size.z * y), 0 for empty. Boxes stay inside, so that no
/// place in them has a negative coordinate.
OpenBoxes measureOpenBoxes(glm::ivec3 size, const std::vector<std::uint32_t>& cells);

}  // namespace orris
