// Where Iris takes `const` away, and where glslang wants it away although drivers do not.
#include <algorithm>
#include <string_view>
#include <unordered_set>
#include <utility>

#include <orris/glsl/rewrite/rewrite_rules.h>
#include <orris/glsl/tokens/outline.h>

namespace orris {
namespace {

using NameSet = std::unordered_set<std::string_view>;

/// A statement "const type a = x, b = y;", tokens [keyword, end).
struct ConstStatement {
  std::size_t keyword = 0;
  std::size_t end = 0;
};

/// Names of the parameters that `const` stands before, between the parentheses at `open`.
NameSet constParameters(const std::vector<Token>& tokens, std::size_t open) {
  NameSet names;
  bool isConst = false;
  const std::size_t close = closingBracket(tokens, open);
  std::string_view last;
  for (std::size_t i = nextCode(tokens, open); i <= close && i < tokens.size();
       i = nextCode(tokens, i)) {
    if (isIdentifier(tokens[i], "const")) isConst = true;
    if (isPunctuator(tokens[i], "[")) i = std::min(closingBracket(tokens, i), close);
    if (i == close || isPunctuator(tokens[i], ",")) {
      if (isConst && !last.empty()) names.insert(last);
      isConst = false;
      last = {};
    } else if (tokens[i].kind == TokenKind::Identifier) {
      last = tokens[i].text;
    }
  }
  return names;
}

/// Those of [begin, end) that no parenthesis encloses: parameters are none.
std::vector<ConstStatement> constStatements(const std::vector<Token>& tokens, std::size_t begin,
                                            std::size_t end) {
  std::vector<ConstStatement> found;
  for (std::size_t i = begin; i < end; ++i) {
    if (isPunctuator(tokens[i], "(")) i = std::min(closingBracket(tokens, i), end);
    if (i >= end || !isIdentifier(tokens[i], "const")) continue;
    std::size_t last = i;
    while (last < end && !isPunctuator(tokens[last], ";")) ++last;
    found.push_back({i, last});
    i = last;
  }
  return found;
}

/// Does it name one of `set`, or with `unfolded` call a function that glslang does not fold?
bool needs(const std::vector<Token>& tokens, const ConstStatement& statement, const NameSet& set,
           bool unfolded) {
  for (std::size_t i = statement.keyword; i < statement.end; ++i) {
    if (tokens[i].kind != TokenKind::Identifier || precededBy(tokens, i, ".")) continue;
    if (set.contains(tokens[i].text)) return true;
    if (unfolded && isUnfoldedBuiltin(tokens[i].text) && followedBy(tokens, i, "(")) return true;
  }
  return false;
}

/// The names that it declares: each before a "=" of its own.
void addDeclared(const std::vector<Token>& tokens, const ConstStatement& statement, NameSet& set) {
  int depth = 0;
  for (std::size_t i = statement.keyword; i < statement.end; ++i) {
    const Token& token = tokens[i];
    if (isPunctuator(token, "(") || isPunctuator(token, "{")) ++depth;
    if (isPunctuator(token, ")") || isPunctuator(token, "}")) --depth;
    if (depth > 0 || !isPunctuator(token, "=")) continue;
    std::size_t name = previousCode(tokens, i);
    while (name > statement.keyword && tokens[name].kind != TokenKind::Identifier) {
      name = previousCode(tokens, name);
    }
    set.insert(tokens[name].text);
  }
}

class ConstRemoval {
 public:
  explicit ConstRemoval(RewriteContext& context)
      : context_(context), tokens_(context.stream.tokens) {}

  /// Takes `const` from the statements that need it gone, and from those that name what they declare.
  void from(std::vector<ConstStatement> statements, NameSet set, bool unfolded) {
    for (bool again = unfolded || !set.empty(); again;) {
      again = false;
      std::erase_if(statements, [&](const ConstStatement& statement) {
        if (!needs(tokens_, statement, set, unfolded)) return false;
        context_.fired("iris-const", tokens_[statement.keyword].origin);
        edits_.erase(statement.keyword, statement.keyword + 1);
        addDeclared(tokens_, statement, set);
        return again = true;
      });
    }
  }

  void apply() { edits_.apply(context_.stream.tokens); }

 private:
  RewriteContext& context_;
  const std::vector<Token>& tokens_;
  TokenEdits edits_;
};

}  // namespace

// Iris: CompatibilityTransformer.transformEach.
void ruleIrisConst(RewriteContext& context) {
  const auto& tokens = context.stream.tokens;
  ConstRemoval removal(context);
  for (const OutlineItem& item : outline(tokens)) {
    if (item.kind != OutlineItem::Kind::Function) continue;
    const std::size_t open = nextCode(tokens, item.name);
    removal.from(constStatements(tokens, closingBracket(tokens, open), item.end),
                 constParameters(tokens, open), false);
  }
  removal.from(constStatements(tokens, 0, tokens.size()), {}, true);
  removal.apply();
}

}  // namespace orris
