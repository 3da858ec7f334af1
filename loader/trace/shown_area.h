// How much of itself a block of many faces shows.
#pragma once

#include <cstdint>

#include <orris/world/atlas/block_atlas.h>
#include <orris/world/blocks/block_facts.h>

namespace orris {

inline constexpr std::uint8_t kAllFaces = 0x3f;

/// Area of a convex body that as many lines meet as the fronts of the block's faces, without their holes (Cauchy). Of
/// even radiance, that area times pi leaves the block: what one face sends into another does not count. Lines through
/// other sides of its cell than `sides` (1 << FaceDirection) count as none. In squares of a block's side; of a fluid and
/// what has no shape that of its cell's sides.
float shownArea(const BlockFacts& facts, const BlockAtlas& atlas, std::uint8_t sides = kAllFaces);

}  // namespace orris
