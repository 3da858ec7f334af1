// Membership in the block tags that packs name in block.properties. Contract: idmaps.csv block.tag.
#pragma once

#include <string_view>

namespace orris {

/// Is the tag ("minecraft:leaves") one that this host knows?
bool isKnownBlockTag(std::string_view tag);

/// Does the block ("minecraft:oak_leaves") carry the tag? False for an unknown tag.
bool hasBlockTag(std::string_view block, std::string_view tag);

}  // namespace orris
