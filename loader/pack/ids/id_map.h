// block.properties, item.properties, entity.properties: names to the numbers shaders see.
// Contract: idmaps.csv.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <orris/core/diagnostic.h>

namespace orris {

/// One name on a block.<id> line: "minecraft:oak_stairs" with required properties.
struct BlockFilter {
  std::string name;  ///< with namespace
  std::vector<std::pair<std::string, std::vector<std::string>>>
      properties;  ///< name, any of values
  bool isTag = false;
  int id = -1;
};

struct BlockIdMap {
  bool present = false;                             ///< block.properties exists
  std::vector<BlockFilter> filters;                 ///< in file order
  std::map<std::string, std::string> renderLayers;  ///< block name -> "solid", "cutout", ...

  /// Id of a state, -1 when unlisted. The first matching filter wins; names before tags.
  int idOf(const std::string& name, const std::map<std::string, std::string>& properties) const;
};

/// "[%][ns:]name[:property=value...]", a word of a block.<id> line. A part that is no property=value
/// is left out and added to `badParts`.
BlockFilter parseBlockFilter(std::string_view word, int id, std::vector<std::string>& badParts);
/// Of a property given twice the last counts.
void keepLastProperties(BlockFilter& filter);

/// `text` is already preprocessed, `original` is what the author wrote, line by line the same.
BlockIdMap parseBlockProperties(const std::string& file, const std::string& text,
                                const std::string& original, Diagnostics& diagnostics);
/// item.properties and entity.properties: name -> id; `prefix` is "item." or "entity.".
std::map<std::string, int> parseIdProperties(const std::string& file, const std::string& text,
                                             const std::string& original, const std::string& prefix,
                                             Diagnostics& diagnostics);

}  // namespace orris
