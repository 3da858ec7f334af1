// What blocks take over from those beside them, in worlds whose files do not say it.
#pragma once

#include <orris/world/blocks/block_world.h>

namespace orris {

/// Fences, walls, panes and rails meet what stands beside them, as the game has it. A block whose state names a side or
/// a shape keeps it.
void joinSides(BlockWorld& world);

/// Parts that a numeric id cannot name: corners of stairs, halves of double chests, and what one half of a door or of a
/// tall plant says for both. A block whose state names it keeps it.
void completeParts(BlockWorld& world);

}  // namespace orris
