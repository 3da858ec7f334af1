// Is a function well-formed GLSL? Without types or declarations, as a parser sees it that only reads:
// what Iris asks of the functions that it leaves out. Iris: glsl-transformer's grammar.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace orris {

struct SyntaxMistake {
  std::size_t offset = 0;  ///< in the text, of the token that does not belong there
  std::string message;     ///< "syntax error: expected ';' before '}'"
};

/// The first mistake of a text that holds function definitions and nothing else.
std::optional<SyntaxMistake> findSyntaxMistake(std::string_view functions);

}  // namespace orris
