// The code of a final text as tokens that know their offset: what edits of it reason with.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <orris/glsl/tokens/token.h>

namespace orris {

/// Tokens of `text` without its lines of directives; the columns of their origins are offsets plus 1.
std::vector<Token> codeTokens(const std::string& text);

inline std::size_t offsetOf(const Token& token) {
  return static_cast<std::size_t>(token.origin.column - 1);
}

}  // namespace orris
