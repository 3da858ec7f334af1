// Names and values in const directives, as text.
#pragma once

#include <cstddef>
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

/// What Iris makes of "vec4(1.0, 0.0, 0.5, 1.0)".
struct VectorValue {
  enum class Use {
    Taken,
    Ignored,  ///< one of the numbers is none
    Refused   ///< there are too few: Iris refuses the whole pack
  };
  Use use = Use::Taken;
  std::vector<float> numbers{};
};

/// The first `count` numbers of a value of the type, which Iris cuts off unseen; ints where the type
/// is an ivec. Iris: DispatchingDirectiveHolder, ComputeDirectiveParser.
VectorValue parseVector(std::string_view value, std::string_view type, std::size_t count);

/// "true" or "false": in const lines 1 and 0 are none.
std::optional<bool> parseConstBoolean(std::string_view value);

}  // namespace orris
