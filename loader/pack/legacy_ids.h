// The block ids of a pack without block.properties: the numbers blocks had before Minecraft 1.13.
// Contract: idmaps.csv block.default.
#pragma once

#include "pack/id_map.h"

namespace orris {

/// `present` stays false.
BlockIdMap legacyBlockIds();

}  // namespace orris
