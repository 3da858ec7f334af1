#include <orris/world/mesh/section_links.h>

#include <orris/world/blocks/block_facts.h>

namespace orris {
namespace {

constexpr int kSectionCells = 16;

/// Sides of the section that a cell lies at.
std::uint8_t sidesAt(glm::ivec3 cell) {
  std::uint8_t sides = 0;
  for (int side = 0; side < 6; ++side) {
    const glm::ivec3 beyond = cell + normalOf(FaceDirection(side));
    if (glm::any(glm::lessThan(beyond, glm::ivec3(0))) || glm::any(glm::greaterThanEqual(beyond, glm::ivec3(kSectionCells))))
      sides |= std::uint8_t(1 << side);
  }
  return sides;
}

/// Fills the open cells that `start` is joined to, and says which sides they reach.
std::uint8_t sidesReachedFrom(glm::ivec3 start, OpaqueCells& filled, std::vector<glm::ivec3>& waiting) {
  std::uint8_t reached = 0;
  filled.set(indexOfCell(start));
  waiting.assign(1, start);
  while (!waiting.empty()) {
    const glm::ivec3 cell = waiting.back();
    waiting.pop_back();
    const std::uint8_t sides = sidesAt(cell);
    reached |= sides;
    for (int side = 0; side < 6; ++side) {
      const glm::ivec3 next = cell + normalOf(FaceDirection(side));
      if ((sides >> side & 1) != 0 || filled.test(indexOfCell(next))) continue;
      filled.set(indexOfCell(next));
      waiting.push_back(next);
    }
  }
  return reached;
}

}  // namespace

SectionLinks linksOf(const OpaqueCells& opaque) {
  SectionLinks links;
  if (opaque.count() < kSectionCells * kSectionCells) return links;
  links.from.fill(0);
  OpaqueCells filled = opaque;
  std::vector<glm::ivec3> waiting;
  // What reaches no side links none: only cells at one are begun with.
  for (int y = 0; y < kSectionCells; ++y)
    for (int z = 0; z < kSectionCells; ++z)
      for (int x = 0; x < kSectionCells; ++x) {
        const glm::ivec3 cell(x, y, z);
        if (filled.test(indexOfCell(cell)) || sidesAt(cell) == 0) continue;
        const std::uint8_t reached = sidesReachedFrom(cell, filled, waiting);
        for (int side = 0; side < 6; ++side)
          if ((reached >> side & 1) != 0) links.from[std::size_t(side)] |= reached;
      }
  return links;
}

}  // namespace orris
