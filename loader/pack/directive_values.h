// Names and values in const directives, as text.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace orris {

/// "colortex4Format" is {false, 4, "Format"}; legacy names count as colortex.
struct TargetKey {
  bool shadow = false;
  int index = -1;
  std::string_view suffix;
};

/// nullopt when the name does not start with that of a colortex or shadowcolor.
std::optional<TargetKey> parseTargetKey(std::string_view key);

/// The numbers of "vec4(1.0, 0.0, 0.5, 1.0)"; nullopt unless there are `count`.
std::optional<std::vector<float>> parseVector(std::string_view value, std::string_view type,
                                              size_t count);

}  // namespace orris
