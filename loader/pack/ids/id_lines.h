// The lines of an id map as Iris joins and splits them. Contract: idmaps.csv common.*.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <orris/pack/files/properties_text.h>

namespace orris {

/// All entries in order of appearance, duplicates included. `text` is preprocessed, `original` is
/// what the author wrote, line by line the same. `diagnostics`, when given, gets what Iris swallows:
/// keys after a line that ends in a backslash, and the letter before a key. Iris: IdMap.
std::vector<PropertyEntry> parseIdLines(const std::string& file, std::string_view text,
                                        std::string_view original, Diagnostics* diagnostics);

}  // namespace orris
