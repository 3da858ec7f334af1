#include <orris/pack/programs/directive_values.h>

#include <algorithm>
#include <array>

#include <orris/pack/files/text.h>

namespace orris {
namespace {

constexpr std::array<std::string_view, 8> kLegacyNames{"gcolor", "gdepth", "gnormal", "composite",
                                                       "gaux1",  "gaux2",  "gaux3",   "gaux4"};

std::optional<float> wholeNumber(std::string_view text) {
  const auto number = parseInteger(text);
  return number ? std::optional(static_cast<float>(*number)) : std::nullopt;
}

}  // namespace

std::optional<TargetKey> parseTargetKey(std::string_view key) {
  for (size_t i = 0; i < kLegacyNames.size(); ++i) {
    if (key.starts_with(kLegacyNames[i])) {
      return TargetKey{false, static_cast<int>(i), key.substr(kLegacyNames[i].size())};
    }
  }
  const bool shadow = key.starts_with("shadowcolor") || key.starts_with("shadowColor");
  if (!shadow && !key.starts_with("colortex")) return std::nullopt;
  const std::string_view rest = key.substr(shadow ? 11 : 8);
  const size_t digits = std::min(rest.find_first_not_of("0123456789"), rest.size());
  const auto index = digits > 0 && digits < 4 ? parseInteger(rest.substr(0, digits)) : std::nullopt;
  if (!index) return std::nullopt;
  return TargetKey{shadow, static_cast<int>(*index), rest.substr(digits)};
}

VectorValue parseVector(std::string_view value, std::string_view type, size_t count) {
  using Use = VectorValue::Use;
  const std::string_view arguments = trim(value.substr(std::min(type.size(), value.size())));
  if (value.size() < type.size() || arguments.size() < 2) return {Use::Refused};
  VectorValue result;
  const auto parts = splitAt(arguments.substr(1, arguments.size() - 2), ',');
  for (size_t i = 0; i < count; ++i) {
    if (i == parts.size()) return {Use::Refused};
    const auto number =
        type.starts_with('i') ? wholeNumber(trim(parts[i])) : parseFloat(trim(parts[i]));
    if (!number) return {Use::Ignored};
    result.numbers.push_back(*number);
  }
  return result;
}

std::optional<bool> parseConstBoolean(std::string_view value) {
  return value == "true" || value == "false" ? std::optional(value == "true") : std::nullopt;
}

}  // namespace orris
