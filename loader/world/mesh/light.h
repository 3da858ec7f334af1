// Vanilla block and sky light, 0..15 a block, for the lightmap coordinates.
#pragma once

#include <vector>

#include <orris/world/blocks/block_facts.h>
#include <orris/world/blocks/block_world.h>
#include <orris/world/mesh/level_grid.h>

namespace orris {

/// Levels of the world's box grown by one block on each side; outside it sky is 15, or 0 without skylight, and block 0.
class LightLevels {
 public:
  LightLevels(const BlockWorld& blocks, const std::vector<BlockFacts>& factsByPalette, bool skylight = true);
  int block(glm::ivec3 p) const { return inside(p) ? block_.at(p) : 0; }
  int sky(glm::ivec3 p) const { return inside(p) ? sky_.at(p) : outsideSky_; }

 private:
  bool inside(glm::ivec3 p) const {
    const glm::ivec3 q = p - origin_;
    return unsigned(q.x) < unsigned(size_.x) && unsigned(q.y) < unsigned(size_.y) &&
           unsigned(q.z) < unsigned(size_.z);
  }
  glm::ivec3 origin_, size_;
  LevelGrid block_, sky_;
  int outsideSky_;
};

}  // namespace orris
