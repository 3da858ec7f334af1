#include <orris/pack/options/live_options.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>

namespace orris {
namespace {

/// nullopt: no decimal literal of GLSL, with or without a sign.
std::optional<LiveType> numberTypeOf(std::string_view value) {
  const auto take = [&](auto&& wanted) {
    std::size_t count = 0;
    while (count < value.size() && wanted(value[count])) ++count;
    value.remove_prefix(count);
    return count;
  };
  const auto isDigit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
  if (!value.empty() && (value.front() == '-' || value.front() == '+')) value.remove_prefix(1);
  const bool octal = value.size() > 1 && value[0] == '0' && isDigit(value[1]);
  std::size_t digits = take(isDigit);
  if (value.empty()) return digits > 0 && !octal ? std::optional(LiveType::Int) : std::nullopt;
  if (value.front() == '.') {
    value.remove_prefix(1);
    digits += take(isDigit);
  }
  if (digits == 0) return std::nullopt;
  if (!value.empty() && (value.front() == 'e' || value.front() == 'E')) {
    value.remove_prefix(1);
    if (!value.empty() && (value.front() == '-' || value.front() == '+')) value.remove_prefix(1);
    if (take(isDigit) == 0) return std::nullopt;
  }
  if (value == "f" || value == "F") value = {};
  return value.empty() ? std::optional(LiveType::Float) : std::nullopt;
}

}  // namespace

std::optional<LiveType> liveType(const Option& option) {
  if (option.isBoolean || option.values.size() < 2) return std::nullopt;
  const auto first = numberTypeOf(option.values.front());
  const bool same = std::ranges::all_of(
      option.values, [&](const std::string& value) { return numberTypeOf(value) == first; });
  return same && numberTypeOf(option.defaultValue) == first ? first : std::nullopt;
}

double liveNumber(const std::string& value) { return std::strtod(value.c_str(), nullptr); }

std::vector<LiveUniform> liveUniforms(const OptionSet& options, const std::set<std::string>& names) {
  std::vector<LiveUniform> uniforms;
  for (const std::string& option : names) {
    const Option* found = options.find(option);
    const auto type = found == nullptr ? std::nullopt : liveType(*found);
    if (!type) continue;
    const std::string name = std::string(kLivePrefix) + option;
    uniforms.push_back(
        {option, name, (*type == LiveType::Int ? "uniform int " : "uniform float ") + name + ";"});
  }
  return uniforms;
}

}  // namespace orris
