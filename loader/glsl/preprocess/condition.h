// The expression of an #if, after macro expansion.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <orris/glsl/tokens/token.h>

namespace orris {

/// What an #if expression amounts to. Identifiers are 0, numbers are cut to integers.
struct ConditionResult {
  std::int64_t value = 0;
  std::string problem;        ///< why there is no value; "" when there is one
  std::size_t problemAt = 0;  ///< index of the token concerned, or tokens.size()
  std::size_t used = 0;       ///< tokens read; the rest is trailing text
};

/// Evaluates `tokens` (no comments). Integer arithmetic in 64 bits, C precedence; an operand that
/// && || or ?: does not need may divide by zero.
ConditionResult evaluateCondition(const std::vector<Token>& tokens);

}  // namespace orris
