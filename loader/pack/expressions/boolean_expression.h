// Conditions on program.<name>.enabled lines.
#pragma once

#include <functional>
#include <optional>
#include <string_view>

namespace orris {

/// Value of names joined by ! && || and parentheses, && before ||. nullopt when `text` is no such
/// expression. Contract: properties.csv "program.<program>.enabled". Iris: BooleanParser.
std::optional<bool> evaluateCondition(std::string_view text,
                                      const std::function<bool(std::string_view)>& valueOf);

}  // namespace orris
