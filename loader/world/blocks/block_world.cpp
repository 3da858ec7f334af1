#include <orris/world/blocks/block_world.h>

#include <algorithm>
#include <cassert>

namespace orris {

BlockWorld::BlockWorld(glm::ivec3 origin, glm::ivec3 size)
    : origin_(origin),
      size_(size),
      firstSection_(origin >> 4),
      sectionCount_(((origin + size - 1) >> 4) - firstSection_ + 1),
      palette_{{"minecraft:air", {}}} {
  assert(size.x >= 0 && size.y >= 0 && size.z >= 0);
  indexOf_.emplace(palette_.front(), 0);
  const bool empty = size.x == 0 || size.y == 0 || size.z == 0;
  if (empty) sectionCount_ = glm::ivec3(0);
  sections_.resize(std::size_t(sectionCount_.x) * std::size_t(sectionCount_.y) *
                   std::size_t(sectionCount_.z));
}

std::uint32_t BlockWorld::paletteIndex(const BlockState& state) {
  const auto [entry, added] = indexOf_.emplace(state, std::uint32_t(palette_.size()));
  if (added) palette_.push_back(state);
  return entry->second;
}

void BlockWorld::set(glm::ivec3 p, std::uint32_t paletteIndex) {
  assert(paletteIndex < palette_.size());
  if (!contains(p)) return;
  Section& section = sections_[sectionAt(p)];
  const auto value = std::uint16_t(paletteIndex);
  if (section.cells.empty()) {
    if (section.only == value) return;
    section.cells.assign(kSectionBlocks, section.only);
  }
  section.cells[cellAt(p)] = value;
}

void BlockWorld::fill(glm::ivec3 from, glm::ivec3 to, std::uint32_t paletteIndex) {
  assert(paletteIndex < palette_.size());
  const glm::ivec3 low = glm::max(glm::min(from, to), origin_);
  const glm::ivec3 high = glm::min(glm::max(from, to), origin_ + size_ - 1);
  if (low.x > high.x || low.y > high.y || low.z > high.z) return;
  const glm::ivec3 first = sectionOrigin(low);
  for (int y = first.y; y <= high.y; y += kSectionSize)
    for (int z = first.z; z <= high.z; z += kSectionSize)
      for (int x = first.x; x <= high.x; x += kSectionSize) {
        const glm::ivec3 at(x, y, z);
        fillInSection(glm::max(low, at), glm::min(high, at + kSectionSize - 1), paletteIndex);
      }
}

void BlockWorld::fillInSection(glm::ivec3 low, glm::ivec3 high, std::uint32_t paletteIndex) {
  if (high - low == glm::ivec3(kSectionSize - 1)) {
    sections_[sectionAt(low)] = {std::uint16_t(paletteIndex), {}};
    return;
  }
  for (int y = low.y; y <= high.y; ++y)
    for (int z = low.z; z <= high.z; ++z)
      for (int x = low.x; x <= high.x; ++x) set({x, y, z}, paletteIndex);
}

std::optional<std::uint32_t> BlockWorld::uniformSection(glm::ivec3 p) const {
  const glm::ivec3 q = (p >> 4) - firstSection_;
  for (int axis = 0; axis < 3; ++axis) {
    if (q[axis] < 0 || q[axis] >= sectionCount_[axis]) return 0;
  }
  const Section& section = sections_[sectionAt(p)];
  if (section.cells.empty()) return section.only;
  return std::nullopt;
}

void BlockWorld::setSection(glm::ivec3 origin, std::vector<std::uint16_t> cells) {
  assert(contains(origin) && contains(origin + kSectionSize - 1));
  assert(origin == sectionOrigin(origin) && cells.size() == kSectionBlocks);
  const bool same = std::all_of(cells.begin(), cells.end(),
                                [&](std::uint16_t index) { return index == cells.front(); });
  Section& section = sections_[sectionAt(origin)];
  section.only = cells.front();
  section.cells = same ? std::vector<std::uint16_t>() : std::move(cells);
}

}  // namespace orris
