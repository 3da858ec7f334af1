// Tokens of a text that may have more than is wanted.
#pragma once

#include <string_view>
#include <vector>

#include <orris/glsl/tokens/token.h>

namespace orris {

/// As tokenizeFrom(); stops when `out` holds `most` tokens, and returns text.size() then.
std::size_t tokenizeAtMost(std::string_view text, std::size_t from, std::size_t most,
                           std::vector<Token>& out);

}  // namespace orris
