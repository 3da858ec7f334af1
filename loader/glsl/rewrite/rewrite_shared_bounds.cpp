// Indices of shared variables that are not literals: the software rasteriser does not bound them, so that a
// pack reads and writes the memory of the process. Elsewhere robust drivers do the same to buffers and images.
#include <algorithm>
#include <set>
#include <utility>

#include <orris/glsl/rewrite/rewrite_rules.h>

namespace orris {
namespace {

// Two overloads and no conversion: an index of another type stays the mistake that it is.
constexpr std::string_view kBound =
    "int orris_bound(int i, int n) { return clamp(i, 0, n - 1); }\n"
    "uint orris_bound(uint i, int n) { return min(i, uint(n - 1)); }";

const std::set<std::string, std::less<>> kBeforeType = {
    "shared", "coherent", "volatile", "restrict", "precise", "highp", "mediump", "lowp", "struct"};

/// Names declared `shared`, and the tokens of their declarations.
struct SharedVariables {
  std::set<std::string, std::less<>> names;
  std::vector<std::pair<std::size_t, std::size_t>> declarations;  ///< [first, last)

  bool declaresAt(std::size_t index) const {
    for (const auto& [first, last] : declarations)
      if (index >= first && index < last) return true;
    return false;
  }
};

/// Behind a type, its brackets or body, or a comma; the type itself stands behind a qualifier.
bool isDeclarator(const std::vector<Token>& tokens, std::size_t index) {
  if (tokens[index].kind != TokenKind::Identifier) return false;
  const Token& before = tokens[previousCode(tokens, index)];
  if (before.kind == TokenKind::Identifier) return !kBeforeType.contains(before.text);
  return before.text == "]" || before.text == "}" || before.text == ",";
}

/// Reads the declaration that begins with `shared` at `first`; returns its end.
std::size_t readDeclaration(const std::vector<Token>& tokens, std::size_t first,
                            SharedVariables& variables) {
  std::size_t i = first + 1;
  while (i < tokens.size() && !isPunctuator(tokens[i], ";")) {
    const bool opens = isPunctuator(tokens[i], "[") || isPunctuator(tokens[i], "{");
    if (opens) i = closingBracket(tokens, i);
    if (i < tokens.size() && isDeclarator(tokens, i)) variables.names.insert(tokens[i].text);
    i = nextCode(tokens, i);
  }
  variables.declarations.emplace_back(first, i);
  return i;
}

SharedVariables findShared(const std::vector<Token>& tokens) {
  SharedVariables variables;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    // layout(shared) is another word.
    const std::size_t next = nextCode(tokens, i);
    if (isIdentifier(tokens[i], "shared") && next < tokens.size() &&
        tokens[next].kind == TokenKind::Identifier)
      i = readDeclaration(tokens, i, variables);
  }
  return variables;
}

/// An index with the comma operator would become two arguments.
bool holdsComma(const std::vector<Token>& tokens, std::size_t open, std::size_t close) {
  for (std::size_t i = open; i < close; ++i)
    if (isPunctuator(tokens[i], ",")) return true;
  return false;
}

bool isLiteral(const std::vector<Token>& tokens, std::size_t open, std::size_t close) {
  const std::size_t inside = nextCode(tokens, open);
  return tokens[inside].kind == TokenKind::Number && nextCode(tokens, inside) == close;
}

/// Bounds the indices in `name[i].member[j]`. The lengths are asked of the same place with other indices,
/// since `.length()` looks at the type alone.
void boundChain(RewriteContext& context, std::size_t name, TokenEdits& edits) {
  const std::vector<Token>& tokens = context.stream.tokens;
  std::string place = tokens[name].text;
  for (std::size_t i = nextCode(tokens, name); i < tokens.size(); i = nextCode(tokens, i)) {
    if (isPunctuator(tokens[i], "[")) {
      const std::size_t close = closingBracket(tokens, i);
      if (close == tokens.size()) return;
      if (!isLiteral(tokens, i, close)) {
        const bool comma = holdsComma(tokens, i, close);
        edits.insertBefore(nextCode(tokens, i), hostTokens(comma ? "orris_bound((" : "orris_bound(", false));
        edits.insertBefore(close, hostTokens((comma ? "), " : ", ") + place + ".length())", false));
        context.fired("shared-bounds", tokens[name].origin);
      }
      place += "[0]";
      i = close;
    } else if (isPunctuator(tokens[i], ".")) {
      i = nextCode(tokens, i);
      if (i >= tokens.size() || followedBy(tokens, i, "(")) return;
      place += "." + tokens[i].text;
    } else {
      return;
    }
  }
}

}  // namespace

void ruleSharedBounds(RewriteContext& context) {
  if (context.stage != Stage::Compute) return;
  const std::vector<Token>& tokens = context.stream.tokens;
  const SharedVariables variables = findShared(tokens);
  if (variables.names.empty()) return;
  TokenEdits edits;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (tokens[i].kind == TokenKind::Identifier && variables.names.contains(tokens[i].text) &&
        !precededBy(tokens, i, ".") && !variables.declaresAt(i))
      boundChain(context, i, edits);
  }
  if (edits.empty()) return;
  edits.apply(context.stream.tokens);
  std::vector<Token> overloads = hostTokens(kBound, true);
  context.stream.tokens.front().newlinesBefore =
      std::max(context.stream.tokens.front().newlinesBefore, 1);
  context.stream.tokens.insert(context.stream.tokens.begin(), overloads.begin(), overloads.end());
}

}  // namespace orris
