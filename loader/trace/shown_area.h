// How much of itself a block of many faces shows.
#pragma once

#include <orris/world/atlas/block_atlas.h>
#include <orris/world/blocks/block_facts.h>

namespace orris {

/// Area of a convex body that as many lines meet as the fronts of the block's faces, without their holes (Cauchy). Of
/// even radiance, that area times pi leaves the block: what one face sends into another does not count. In
/// squares of a block's side; 6 for a fluid and what has no shape.
float shownArea(const BlockFacts& facts, const BlockAtlas& atlas);

}  // namespace orris
