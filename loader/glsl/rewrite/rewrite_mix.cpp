// mix(vecN, vecN, bool): legal nowhere, accepted by some drivers. A user overload named mix would
// hide the built-in ones in Mesa, so only the calls concerned are renamed.
#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>

#include <orris/glsl/rewrite/rewrite_rules.h>
#include <orris/glsl/tokens/outline.h>

namespace orris {
namespace {

struct Range {
  std::size_t begin;
  std::size_t end;
};

constexpr std::string_view kOverloads =
    "float orris_mix(float x, float y, bool a) { return a ? y : x; }\n"
    "vec2 orris_mix(vec2 x, vec2 y, bool a) { return a ? y : x; }\n"
    "vec3 orris_mix(vec3 x, vec3 y, bool a) { return a ? y : x; }\n"
    "vec4 orris_mix(vec4 x, vec4 y, bool a) { return a ? y : x; }\n"
    "ivec2 orris_mix(ivec2 x, ivec2 y, bool a) { return a ? y : x; }\n"
    "ivec3 orris_mix(ivec3 x, ivec3 y, bool a) { return a ? y : x; }\n"
    "ivec4 orris_mix(ivec4 x, ivec4 y, bool a) { return a ? y : x; }\n"
    "uvec2 orris_mix(uvec2 x, uvec2 y, bool a) { return a ? y : x; }\n"
    "uvec3 orris_mix(uvec3 x, uvec3 y, bool a) { return a ? y : x; }\n"
    "uvec4 orris_mix(uvec4 x, uvec4 y, bool a) { return a ? y : x; }\n";

constexpr std::array<std::string_view, 9> kBoolOperators = {
    "||", "&&", "^^", "==", "!=", "<", ">", "<=", ">="};

bool isScalarType(std::string_view type) {
  return type == "float" || type == "int" || type == "uint" || type == "bool" || type == "double";
}

// Answers two questions about expressions, "surely a scalar bool?" and "surely a scalar?", from the
// declarations in the same text. Unknown is "no".
class ExpressionTypes {
 public:
  explicit ExpressionTypes(const std::vector<Token>& tokens) : tokens_(tokens) {
    for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
      if (isIdentifier(tokens[i], "bool")) addBoolNames(i);
    }
  }

  bool isScalarBool(Range range) const {
    range = strip(range);
    if (range.begin >= range.end) return false;
    if (const auto colon = lastAtTop(range, {":"})) return isScalarBool({*colon + 1, range.end});
    if (lastAtTop(range, kBoolOperators)) return true;
    const Token& first = tokens_[range.begin];
    if (isPunctuator(first, "!")) return true;
    if (isIdentifier(first, "true") || isIdentifier(first, "false")) return true;
    return primaryType(range) == "bool";
  }

  bool isScalar(Range range) const {
    range = strip(range);
    if (range.begin >= range.end) return false;
    if (tokens_[range.begin].kind == TokenKind::Number) return range.end - range.begin == 1;
    const std::size_t last = previousCode(tokens_, range.end);
    const bool swizzled = last > range.begin && precededBy(tokens_, last, ".") &&
                          !lastAtTop(range, {"+", "-", "*", "/"});
    if (swizzled && tokens_[last].text.size() == 1) return true;
    return isScalarType(primaryType(range));
  }

 private:
  bool isIdentifierAt(std::size_t i) const {
    return i < tokens_.size() && tokens_[i].kind == TokenKind::Identifier;
  }

  // "bool a, b = c < d;" or "bool f(": notes the names. In "bool a, float b" the list is one of
  // parameters and ends with a.
  void addBoolNames(std::size_t type) {
    std::size_t i = nextCode(tokens_, type);
    while (isIdentifierAt(i) && !isIdentifierAt(nextCode(tokens_, i))) {
      boolNames_.insert(tokens_[i].text);
      i = nextCode(tokens_, i);
      while (i < tokens_.size() && !endsDeclarator(tokens_[i])) {
        const bool opens = isPunctuator(tokens_[i], "(") || isPunctuator(tokens_[i], "[");
        i = nextCode(tokens_, opens ? std::min(closingBracket(tokens_, i), tokens_.size()) : i);
      }
      if (i >= tokens_.size() || !isPunctuator(tokens_[i], ",")) return;
      i = nextCode(tokens_, i);
    }
  }

  static bool endsDeclarator(const Token& token) {
    return isPunctuator(token, ",") || isPunctuator(token, ";") || isPunctuator(token, ")") ||
           isPunctuator(token, "{");
  }

  // Without comments at the ends and parentheses around the whole.
  Range strip(Range range) const {
    while (range.begin < range.end) {
      if (tokens_[range.begin].kind == TokenKind::Comment) {
        ++range.begin;
      } else if (tokens_[range.end - 1].kind == TokenKind::Comment) {
        --range.end;
      } else if (isPunctuator(tokens_[range.begin], "(") &&
                 closingBracket(tokens_, range.begin) == range.end - 1) {
        range = {range.begin + 1, range.end - 1};
      } else {
        break;
      }
    }
    return range;
  }

  template <typename Texts>
  std::optional<std::size_t> lastAtTop(Range range, const Texts& texts) const {
    std::optional<std::size_t> found;
    int depth = 0;
    for (std::size_t i = range.begin; i < range.end; ++i) {
      const Token& token = tokens_[i];
      if (token.kind != TokenKind::Punctuator) continue;
      if (token.text == "(" || token.text == "[") ++depth;
      if (token.text == ")" || token.text == "]") --depth;
      if (depth == 0 && std::find(texts.begin(), texts.end(), token.text) != texts.end()) found = i;
    }
    return found;
  }
  std::optional<std::size_t> lastAtTop(Range range,
                                       std::initializer_list<std::string_view> texts) const {
    return lastAtTop<std::initializer_list<std::string_view>>(range, texts);
  }

  // Type of `name`, `name[i]`, `name(...)`, `a.name`; "" when not known.
  std::string_view primaryType(Range range) const {
    const Token& first = tokens_[range.begin];
    if (first.kind != TokenKind::Identifier) return {};
    const std::size_t last = previousCode(tokens_, range.end);
    if (last > range.begin && tokens_[last].kind == TokenKind::Identifier) {
      const bool member = precededBy(tokens_, last, ".") && !lastAtTop(range, {"+", "-", "*", "/"});
      return member ? memberType(range.begin, last) : std::string_view();
    }
    const std::size_t next = nextCode(tokens_, range.begin);
    if (next < range.end && isPunctuator(tokens_[next], "(")) {
      return closingBracket(tokens_, next) == last ? callType(first.text) : std::string_view();
    }
    if (next < range.end && isPunctuator(tokens_[next], "[")) {
      if (closingBracket(tokens_, next) != last) return {};
      const std::string_view type = declaredType(range.begin);
      return type.starts_with("bvec") ? "bool" : type;
    }
    return next >= range.end ? declaredType(range.begin) : std::string_view();
  }

  // A component of a bvec, or a member that is declared bool wherever that name is declared so.
  std::string_view memberType(std::size_t base, std::size_t member) const {
    const std::string& name = tokens_[member].text;
    if (nextCode(tokens_, nextCode(tokens_, base)) == member && name.size() == 1 &&
        declaredType(base).starts_with("bvec")) {
      return "bool";
    }
    return boolNames_.contains(name) && name.size() > 1 ? "bool" : "";
  }

  std::string_view callType(std::string_view name) const {
    if (name == "any" || name == "all" || boolNames_.contains(name)) return "bool";
    return isScalarType(name) ? name : std::string_view();
  }

  // The nearest declaration before the use.
  std::string_view declaredType(std::size_t use) const {
    const std::string& name = tokens_[use].text;
    for (std::size_t i = use; i-- > 0;) {
      if (tokens_[i].kind != TokenKind::Identifier || tokens_[i].text != name) continue;
      const std::string_view type = typeBefore(i);
      if (!type.empty()) return type;
    }
    return {};
  }

  std::string_view typeBefore(std::size_t name) const {
    const std::size_t before = previousCode(tokens_, name);
    if (before >= tokens_.size()) return {};
    const Token& token = tokens_[before];
    if (token.kind == TokenKind::Identifier) {
      const bool type = token.text != "return" && token.text != "else" && !isQualifier(token.text);
      return type ? std::string_view(token.text) : std::string_view();
    }
    const bool listed = isPunctuator(token, ",") && boolNames_.contains(tokens_[name].text);
    return listed ? listType(before) : std::string_view();
  }

  // Type of a statement "type a, b" from the comma before b.
  std::string_view listType(std::size_t comma) const {
    int depth = 0;
    std::size_t start = comma;
    while (start > 0) {
      const Token& token = tokens_[start - 1];
      if (isPunctuator(token, ")") || isPunctuator(token, "]")) ++depth;
      if (isPunctuator(token, "(") || isPunctuator(token, "[")) --depth;
      if (depth < 0) return {};
      const bool ends =
          isPunctuator(token, ";") || isPunctuator(token, "{") || isPunctuator(token, "}");
      if (depth == 0 && ends) break;
      --start;
    }
    while (start < comma &&
           (tokens_[start].kind == TokenKind::Comment || isQualifier(tokens_[start].text))) {
      ++start;
    }
    const std::size_t next = nextCode(tokens_, start);
    const bool declares = tokens_[start].kind == TokenKind::Identifier && next < tokens_.size() &&
                          tokens_[next].kind == TokenKind::Identifier;
    return declares ? std::string_view(tokens_[start].text) : std::string_view();
  }

  const std::vector<Token>& tokens_;
  std::unordered_set<std::string_view> boolNames_;  // declared bool somewhere in the text
};

std::vector<Range> argumentsOf(const std::vector<Token>& tokens, std::size_t open) {
  std::vector<Range> arguments;
  const std::size_t close = closingBracket(tokens, open);
  std::size_t begin = open + 1;
  int depth = 0;
  for (std::size_t i = open + 1; i <= close && i < tokens.size(); ++i) {
    const Token& token = tokens[i];
    if (token.kind != TokenKind::Punctuator) continue;
    const bool end = i == close || (depth == 0 && token.text == ",");
    if (end) {
      arguments.push_back({begin, i});
      begin = i + 1;
    } else if (token.text == "(" || token.text == "[") {
      ++depth;
    } else if (token.text == ")" || token.text == "]") {
      --depth;
    }
  }
  return arguments;
}

bool definesMix(const std::vector<Token>& tokens) {
  const std::vector<OutlineItem> items = outline(tokens);
  return std::any_of(items.begin(), items.end(), [&tokens](const OutlineItem& item) {
    return item.kind == OutlineItem::Kind::Function && tokens[item.name].text == "mix";
  });
}

}  // namespace

void ruleMixBool(RewriteContext& context) {
  auto& tokens = context.stream.tokens;
  const ExpressionTypes types(tokens);
  std::vector<std::size_t> calls;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (!isIdentifier(tokens[i], "mix") || !followedBy(tokens, i, "(")) continue;
    const std::vector<Range> arguments = argumentsOf(tokens, nextCode(tokens, i));
    if (arguments.size() != 3 || !types.isScalarBool(arguments[2])) continue;
    if (types.isScalar(arguments[0]) || types.isScalar(arguments[1])) continue;
    calls.push_back(i);
  }
  if (calls.empty() || definesMix(tokens)) return;
  for (std::size_t call : calls) {
    context.fired("mix-bool", tokens[call].origin);
    tokens[call].text = "orris_mix";
  }
  std::vector<Token> overloads = hostTokens(kOverloads, true);
  tokens.front().newlinesBefore = std::max(tokens.front().newlinesBefore, 1);
  tokens.insert(tokens.begin(), overloads.begin(), overloads.end());
}

}  // namespace orris
