#include "world/blocks/block_world.h"

#include <algorithm>
#include <cassert>

namespace orris {

BlockWorld::BlockWorld(glm::ivec3 origin, glm::ivec3 size)
    : origin_(origin), size_(size), palette_{{"minecraft:air", {}}} {
  assert(size.x >= 0 && size.y >= 0 && size.z >= 0);
  indexOf_.emplace(palette_.front(), 0);
  blocks_.resize(std::size_t(size.x) * size.y * size.z, 0);
}

bool BlockWorld::contains(glm::ivec3 p) const {
  const glm::ivec3 q = p - origin_;
  return q.x >= 0 && q.y >= 0 && q.z >= 0 && q.x < size_.x && q.y < size_.y && q.z < size_.z;
}

std::size_t BlockWorld::offset(glm::ivec3 p) const {
  const glm::ivec3 q = p - origin_;
  return (std::size_t(q.y) * size_.z + q.z) * size_.x + q.x;
}

std::uint32_t BlockWorld::indexAt(glm::ivec3 p) const {
  return contains(p) ? blocks_[offset(p)] : 0;
}

std::uint32_t BlockWorld::paletteIndex(const BlockState& state) {
  const auto [entry, added] = indexOf_.emplace(state, std::uint32_t(palette_.size()));
  if (added) palette_.push_back(state);
  return entry->second;
}

void BlockWorld::set(glm::ivec3 p, std::uint32_t paletteIndex) {
  assert(paletteIndex < palette_.size());
  if (contains(p)) blocks_[offset(p)] = paletteIndex;
}

void BlockWorld::fill(glm::ivec3 from, glm::ivec3 to, std::uint32_t paletteIndex) {
  assert(paletteIndex < palette_.size());
  const glm::ivec3 low = glm::max(glm::min(from, to), origin_);
  const glm::ivec3 high = glm::min(glm::max(from, to), origin_ + size_ - 1);
  if (low.x > high.x) return;
  for (int y = low.y; y <= high.y; ++y) {
    for (int z = low.z; z <= high.z; ++z) {
      std::fill_n(blocks_.begin() + std::ptrdiff_t(offset({low.x, y, z})), high.x - low.x + 1,
                  paletteIndex);
    }
  }
}

}  // namespace orris
