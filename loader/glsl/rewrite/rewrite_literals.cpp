// "1f": Iris's parser takes it for a float and prints it as 1.0f; GLSL wants the point.
#include <algorithm>

#include <orris/core/characters.h>
#include <orris/glsl/rewrite/rewrite_rules.h>

namespace orris {
namespace {

bool isPointlessFloat(const Token& token) {
  if (token.kind != TokenKind::Number || token.text.size() < 2) return false;
  const std::string_view digits = std::string_view(token.text).substr(0, token.text.size() - 1);
  return (token.text.back() == 'f' || token.text.back() == 'F') &&
         std::ranges::all_of(digits, isDigit);
}

}  // namespace

void ruleFloatLiterals(RewriteContext& context) {
  for (Token& token : context.stream.tokens) {
    if (!isPointlessFloat(token)) continue;
    context.fired("float-literals", token.origin);
    token.text.insert(token.text.size() - 1, ".0");
  }
}

}  // namespace orris
