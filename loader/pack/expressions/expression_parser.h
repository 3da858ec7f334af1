// Text of a custom uniform to a tree without types. Contract: expressions.csv.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <orris/pack/expressions/expression.h>

namespace orris {

/// A parsed expression. Operators are calls of functions named "+", "&&", ..., "!" and "neg".
struct ExpressionTree {
  enum class Kind { Literal, Name, Call };
  Kind kind = Kind::Literal;
  Value literal;
  std::string name;                   ///< of a variable or function
  std::vector<std::string> accesses;  ///< ".x" or ".0.1" after a variable
  std::vector<ExpressionTree> arguments;
  int column = 1;  ///< in the expression text
};

/// Where and why a text is no expression.
struct ExpressionError {
  std::string message;
  int column = 1;
};

/// At most 8192 nodes, nested at most 64 deep.
std::optional<ExpressionTree> parseExpression(std::string_view text, ExpressionError& error);

}  // namespace orris
