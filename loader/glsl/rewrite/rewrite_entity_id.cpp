// uint(mc_Entity.x - 10000.0): blocks without an id have -1, and GLSL leaves negative floats as
// unsigned numbers undefined. Graphics cards make them 0, which packs rely on; Mesa's software
// rasteriser makes them huge.
#include <optional>
#include <set>

#include <orris/glsl/rewrite/rewrite_rules.h>

namespace orris {
namespace {

// Conversions of an id are short; the rest is not searched.
constexpr std::size_t kFarthest = 48;

struct Brackets {
  std::size_t open;
  std::size_t close;
};

/// The brackets of the innermost uint(...) around the token at `index`.
std::optional<Brackets> conversionAround(const std::vector<Token>& tokens, std::size_t index) {
  std::size_t depth = 0, open = index;
  for (std::size_t i = index; i-- > 0 && index - i < kFarthest;) {
    if (isPunctuator(tokens[i], ")")) ++depth;
    if (!isPunctuator(tokens[i], "(") || depth-- > 0) continue;
    depth = 0;
    const std::size_t called = previousCode(tokens, i);
    if (called >= tokens.size() || !isIdentifier(tokens[called], "uint")) continue;
    open = i;
    break;
  }
  if (open == index) return std::nullopt;
  depth = 0;
  for (std::size_t i = open; i < tokens.size() && i - open < 2 * kFarthest; ++i) {
    if (isPunctuator(tokens[i], "(")) ++depth;
    if (isPunctuator(tokens[i], ")") && --depth == 0) return Brackets{open, i};
  }
  return std::nullopt;
}

}  // namespace

void ruleEntityId(RewriteContext& context) {
  if (context.stage != Stage::Vertex) return;
  const std::vector<Token>& tokens = context.stream.tokens;
  TokenEdits edits;
  std::set<std::size_t> done;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (!isIdentifier(tokens[i], "mc_Entity")) continue;
    const auto brackets = conversionAround(tokens, i);
    if (!brackets || !done.insert(brackets->open).second) continue;
    edits.insertBefore(brackets->open + 1, hostTokens("max(", false));
    edits.insertBefore(brackets->close, hostTokens(", 0.0)", false));
    context.fired("entity-id", tokens[i].origin);
  }
  edits.apply(context.stream.tokens);
}

}  // namespace orris
