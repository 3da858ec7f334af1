// Vanilla block and sky light, 0..15 a block, for the lightmap coordinates.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "world/blocks/block_facts.h"
#include "world/blocks/block_world.h"

namespace orris {

/// Levels of the world's box grown by one block on each side; outside it sky is 15 and block 0.
class LightLevels {
 public:
  LightLevels(const BlockWorld& blocks, const std::vector<BlockFacts>& factsByPalette);
  int block(glm::ivec3 p) const;
  int sky(glm::ivec3 p) const;

 private:
  std::size_t offset(glm::ivec3 p) const;
  glm::ivec3 origin_, size_;
  std::vector<std::uint8_t> levels_;  // block in the low nibble, sky in the high one
};

}  // namespace orris
