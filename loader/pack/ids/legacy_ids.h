// The block ids of a pack without block.properties: the numbers blocks had before Minecraft 1.13.
// Contract: idmaps.csv block.default.
#pragma once

#include <orris/pack/ids/id_map.h>

namespace orris {

/// The first version whose "grass" is called short_grass, which Iris's table does not know.
inline constexpr long long kShortGrassVersion = 12003;

/// `present` stays false. `minecraftVersion` as in MC_VERSION.
BlockIdMap legacyBlockIds(long long minecraftVersion);

}  // namespace orris
