#include <orris/plan/frame/visible_sections.h>

#include <orris/world/mesh/block_faces.h>

namespace orris {
namespace {

constexpr int kHere = 6;  // entered by no side

struct SectionEntry {
  glm::ivec3 section;
  int side;
};

int axisOf(int side) {
  const glm::ivec3 normal = normalOf(FaceDirection(side));
  return normal.x != 0 ? 0 : normal.y != 0 ? 1 : 2;
}

bool isInside(glm::ivec3 section, glm::ivec3 size) {
  return glm::all(glm::greaterThanEqual(section, glm::ivec3(0))) && glm::all(glm::lessThan(section, size));
}

/// The section of the eye, or those at the sides of the box that an eye outside of it sees.
std::vector<SectionEntry> firstOf(const SectionGrid& grid, glm::ivec3 eye) {
  if (isInside(eye, grid.size)) return {{eye, kHere}};
  std::vector<SectionEntry> first;
  for (int side = 0; side < 6; ++side) {
    const int axis = axisOf(side), last = grid.size[axis] - 1;
    const bool high = normalOf(FaceDirection(side))[axis] > 0;
    if (high ? eye[axis] <= last : eye[axis] >= 0) continue;
    glm::ivec3 low(0), end = grid.size;
    low[axis] = high ? last : 0;
    end[axis] = low[axis] + 1;
    for (int x = low.x; x < end.x; ++x)
      for (int y = low.y; y < end.y; ++y)
        for (int z = low.z; z < end.z; ++z) first.push_back({{x, y, z}, side});
  }
  return first;
}

}  // namespace

VisibleSections::VisibleSections(const SectionGrid& grid, const glm::dvec3& eye)
    : origin_(grid.origin), size_(grid.size), seen_(grid.links.size(), 0) {
  const glm::ivec3 here(glm::floor((eye - glm::dvec3(grid.origin)) / 16.0));
  std::vector<SectionEntry> waiting = firstOf(grid, here);
  for (const SectionEntry& entry : waiting) seen_[indexOf(entry.section)] |= std::uint8_t(1 << entry.side);
  while (!waiting.empty()) {
    const auto [section, entered] = waiting.back();
    waiting.pop_back();
    const std::uint8_t leaves = entered == kHere ? SectionLinks::kAll
                                                 : grid.links[indexOf(section)].from[std::size_t(entered)];
    for (int side = 0; side < 6; ++side) {
      const glm::ivec3 normal = normalOf(FaceDirection(side));
      const int axis = axisOf(side);
      const bool turnsBack = (section[axis] - here[axis]) * normal[axis] < 0;
      const glm::ivec3 next = section + normal;
      if ((leaves >> side & 1) == 0 || turnsBack || !isInside(next, grid.size)) continue;
      const int into = int(opposite(FaceDirection(side)));
      std::uint8_t& seen = seen_[indexOf(next)];
      if ((seen >> into & 1) != 0) continue;
      seen |= std::uint8_t(1 << into);
      waiting.push_back({next, into});
    }
  }
}

}  // namespace orris
