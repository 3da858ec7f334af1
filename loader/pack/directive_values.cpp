#include "pack/directive_values.h"

#include <algorithm>
#include <array>

#include "pack/text.h"

namespace orris {
namespace {

constexpr std::array<std::string_view, 8> kLegacyNames{"gcolor", "gdepth", "gnormal", "composite",
                                                       "gaux1",  "gaux2",  "gaux3",   "gaux4"};

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

std::optional<std::vector<float>> parseVector(std::string_view value, std::string_view type,
                                              size_t count) {
  if (!value.starts_with(type)) return std::nullopt;
  value = trim(value.substr(type.size()));
  if (!value.starts_with('(') || !value.ends_with(')')) return std::nullopt;
  std::vector<float> numbers;
  for (const std::string_view part : splitAt(value.substr(1, value.size() - 2), ',')) {
    const auto number = parseFloat(trim(part));
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers.size() == count ? std::optional(numbers) : std::nullopt;
}

}  // namespace orris
