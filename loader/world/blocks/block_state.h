// Block states in Minecraft's notation: "minecraft:oak_stairs[facing=north,half=bottom]".
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace orris {

struct BlockState {
  std::string name;  ///< with namespace
  std::map<std::string, std::string> properties;
  bool operator==(const BlockState&) const = default;
  auto operator<=>(const BlockState&) const = default;
  /// A property's value, `fallback` when absent.
  std::string_view property(const std::string& key, std::string_view fallback = "") const;
  std::string toString() const;
};

/// "stone" and "minecraft:stone[...]"; nullopt when malformed.
std::optional<BlockState> parseBlockState(std::string_view text);

}  // namespace orris
