// Options whose value is only a number in code: they can be uniforms in place of macros, so that another
// value needs no build.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <orris/pack/options/options.h>

namespace orris {

/// What stands in the texts in place of an option.
struct LiveUniform {
  std::string option;
  std::string name;         ///< GLSL: "orris_live_EXPOSURE"
  std::string declaration;  ///< GLSL, whole
};

inline constexpr std::string_view kLivePrefix = "orris_live_";

/// Of those of `names` that are options whose values are numbers of one kind, in the order of names.
std::vector<LiveUniform> liveUniforms(const OptionSet& options, const std::set<std::string>& names);

/// Is every value a whole number, or every one a number with a point or an exponent? GLSL gives the two
/// different types. nullopt: neither.
enum class LiveType { Int, Float };
std::optional<LiveType> liveType(const Option& option);

/// The number that a value of such an option is, as a compiler reads it.
double liveNumber(const std::string& value);

}  // namespace orris
