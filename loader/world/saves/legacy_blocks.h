// Numeric block ids of 1.12 and before, as block states.
#pragma once

#include <orris/world/blocks/block_state.h>

namespace orris {

/// The state of an id (0 to 4095) and its four bits of data. What the table lacks, ids of mods among it,
/// becomes "legacy:ID", which no block has.
BlockState legacyState(int id, int data);

}  // namespace orris
