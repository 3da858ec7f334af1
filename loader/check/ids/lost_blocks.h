// Entries of block.properties that do nothing because an earlier one has their blocks already.
#pragma once

#include <string>
#include <vector>

#include <orris/core/diagnostic.h>
#include <orris/pack/files/properties_text.h>

namespace orris {

/// One entry of a block under a key.
struct ListedBlock {
  const PropertyEntry* entry = nullptr;  ///< of the key; outlives this
  std::string text;                      ///< "lantern:hanging=true"
  SourceLocation at;
  bool states = false;  ///< for some states of the block, not for all
};

/// `word` does nothing, because all its states are those of `first` already.
struct LostBlock {
  ListedBlock first, word;
};

/// Reports id-twice and, within one key, id-repeated. Entries that are lost for one cause, an entry
/// that takes too much or a line that was copied, are one finding.
void reportLostBlocks(const std::vector<LostBlock>& lost, Diagnostics& diagnostics);

}  // namespace orris
