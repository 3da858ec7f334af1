#include <orris/glsl/syntax/stage_size.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include <orris/core/limits.h>
#include <orris/glsl/preprocess/condition.h>

namespace orris {
namespace {

/// The tokens of a stage without its comments.
class CodeTokens {
 public:
  explicit CodeTokens(const std::vector<Token>& tokens) {
    tokens_.reserve(tokens.size());
    for (const Token& token : tokens)
      if (token.kind != TokenKind::Comment) tokens_.push_back(&token);
  }

  std::size_t size() const { return tokens_.size(); }
  const Token& operator[](std::size_t i) const { return *tokens_[i]; }
  bool isName(std::size_t i) const { return i < size() && tokens_[i]->kind == TokenKind::Identifier; }
  bool isMark(std::size_t i, char mark) const {
    return i < size() && tokens_[i]->kind == TokenKind::Punctuator && tokens_[i]->text.size() == 1 &&
           tokens_[i]->text[0] == mark;
  }
  /// Index of the first `mark` from `i` on that stands in no bracket which opens behind `i`, or of what ends
  /// them: a bracket that closes more, or the text.
  std::size_t find(std::size_t i, std::string_view marks) const {
    for (int depth = 0; i < size(); ++i) {
      const Token& token = *tokens_[i];
      if (token.kind != TokenKind::Punctuator || token.text.size() != 1) continue;
      const char c = token.text[0];
      if (depth == 0 && marks.find(c) != std::string_view::npos) return i;
      if (c == '(' || c == '[' || c == '{') ++depth;
      if ((c == ')' || c == ']' || c == '}') && --depth < 0) return i;
    }
    return i;
  }

 private:
  std::vector<const Token*> tokens_;
};

/// How large functions are when those that they call stand in place of the calls.
class InlinedSizes {
 public:
  explicit InlinedSizes(const CodeTokens& tokens) : tokens_(tokens) { readFunctions(); }

  /// The name of the first function with too many tokens that is found from main() on.
  const Token* tooLarge() {
    const auto main = functions_.find("main");
    if (main != functions_.end()) visit(main->second);
    return found_;
  }

 private:
  struct Body {
    const Token* name = nullptr;
    std::size_t tokens = 0;
    std::vector<std::string_view> calls;
  };
  /// All of one name: which of them a call means depends on types. The largest stands for them.
  struct Function {
    std::vector<Body> bodies;
    std::size_t size = 0;
    bool visited = false;
  };

  void readFunctions() {
    std::size_t name = tokens_.size();
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      if (tokens_.isName(i) && tokens_.isMark(i + 1, '(')) {
        name = i++;
        i = tokens_.find(i + 1, ")");
      } else if (tokens_.isMark(i, '{')) {
        const bool body = i > 0 && tokens_.isMark(i - 1, ')') && name < i;
        i = body ? readBody(name, i) : tokens_.find(i + 1, "}");
      }
    }
  }

  /// Returns where it ends.
  std::size_t readBody(std::size_t name, std::size_t open) {
    const std::size_t end = tokens_.find(open + 1, "}");
    Body body{&tokens_[name], end - name, {}};
    for (std::size_t i = open; i < end; ++i)
      if (tokens_.isName(i) && tokens_.isMark(i + 1, '(')) body.calls.push_back(tokens_[i].text);
    functions_[body.name->text].bodies.push_back(std::move(body));
    return end;
  }

  /// Those that a function calls first; by a list, since chains of calls may be long.
  void visit(Function& main) {
    std::vector<Function*> open = {&main};
    while (!open.empty()) {
      Function& function = *open.back();
      if (std::exchange(function.visited, true)) {
        count(function);
        open.pop_back();
        continue;
      }
      for (const Body& body : function.bodies)
        for (const std::string_view call : body.calls)
          if (const auto called = functions_.find(call); called != functions_.end() && !called->second.visited)
            open.push_back(&called->second);
    }
  }

  /// A body sees those of its own name that stand before it. What calls itself is refused by every compiler.
  void count(Function& function) {
    if (function.size != 0) return;
    for (const Body& body : function.bodies) {
      std::size_t all = body.tokens;
      for (const std::string_view call : body.calls)
        if (const auto called = functions_.find(call); called != functions_.end())
          all = std::min(all + called->second.size, kMost);
      function.size = std::max(function.size, all);
      if (all > limits::kInlinedTokens && !found_) found_ = body.name;
    }
  }

  static constexpr std::size_t kMost = std::size_t{1} << 60;
  const CodeTokens& tokens_;
  std::map<std::string_view, Function> functions_;
  const Token* found_ = nullptr;
};

/// Lengths of arrays that are numbers, or made of constants that are.
class ArrayLengths {
 public:
  explicit ArrayLengths(const CodeTokens& tokens) : tokens_(tokens) {}

  /// The first array with too many elements: its name, or its type where the brackets follow that.
  const Token* tooLarge() {
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      if (isOneOf(tokens_[i].text, ";{}()")) {
        declares_ = false;
      } else if (isNotOfDriver(i)) {
        i = tokens_.find(i, ";{");
        if (tokens_.isMark(i, '{')) i = tokens_.find(i + 1, "}");
      } else if (declares_ && tokens_.isMark(i, '=')) {
        keepConstant(i);
        i = tokens_.find(i, ",;") - 1;
      } else if (tokens_.isName(i) && isTooLarge(i)) {
        return &tokens_[i];
      }
    }
    return nullptr;
  }

 private:
  static constexpr std::array<std::string_view, 5> kBeforeValue = {"return", "else", "case", "do", "in"};

  static bool isOneOf(std::string_view text, std::string_view marks) {
    return text.size() == 1 && marks.find(text[0]) != std::string_view::npos;
  }

  /// Buffers hold what memory does, a driver bounds what is shared, and a struct may be of either.
  bool isNotOfDriver(std::size_t i) const {
    const std::string& text = tokens_[i].text;
    return tokens_.isName(i) && (text == "buffer" || text == "shared" || text == "struct");
  }

  bool isTooLarge(std::size_t i) {
    const bool behindType = i > 0 && tokens_.isName(i - 1) &&
                            std::ranges::find(kBeforeValue, tokens_[i - 1].text) == kBeforeValue.end();
    const bool declared = behindType || (declares_ && i > 0 && tokens_.isMark(i - 1, ','));
    if (declared) declares_ = true;
    if (!tokens_.isMark(i + 1, '[')) return false;
    const auto [elements, end] = lengthAt(i + 1);
    if (!declared && !tokens_.isName(end)) return false;
    declares_ = true;
    return elements > std::int64_t{limits::kArrayElements};
  }

  /// Of all brackets from `open` on multiplied, and where they end; 0: not known.
  std::pair<std::int64_t, std::size_t> lengthAt(std::size_t open) const {
    constexpr std::int64_t kMost = std::int64_t{1} << 31;
    std::int64_t all = 1;
    while (tokens_.isMark(open, '[')) {
      const std::size_t close = tokens_.find(open + 1, "]");
      const std::int64_t own = valueOf(open + 1, close).value_or(0);
      all = own > 0 && own < kMost ? std::min(all * own, kMost) : own > 0 ? kMost : 0;
      open = close + 1;
    }
    return {all, open};
  }

  std::optional<std::int64_t> valueOf(std::size_t begin, std::size_t end) const {
    constexpr std::size_t kLongest = 64;
    if (begin >= end || end - begin > kLongest) return std::nullopt;
    std::vector<Token> words;
    for (std::size_t i = begin; i < end; ++i) {
      Token& word = words.emplace_back(tokens_[i]);
      if (word.kind != TokenKind::Identifier) continue;
      const auto known = constants_.find(word.text);
      if (known == constants_.end()) return std::nullopt;
      word.kind = TokenKind::Number;
      word.text = std::to_string(known->second);
    }
    const ConditionResult result = evaluateCondition(words);
    return result.problem.empty() && result.used == words.size() ? std::optional(result.value) : std::nullopt;
  }

  /// "const int N = 4" with the "=" at `i`.
  void keepConstant(std::size_t i) {
    if (i < 3 || tokens_[i - 3].text != "const" || (tokens_[i - 2].text != "int" && tokens_[i - 2].text != "uint"))
      return;
    if (const auto value = valueOf(i + 1, tokens_.find(i + 1, ",;"))) constants_[tokens_[i - 1].text] = *value;
  }

  const CodeTokens& tokens_;
  std::map<std::string_view, std::int64_t> constants_;
  bool declares_ = false;  ///< commas part names
};

const Token* tooManyCases(const CodeTokens& tokens) {
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (!isIdentifier(tokens[i], "switch")) continue;
    const Token* const found = &tokens[i];
    i = tokens.find(i, "{;");
    const std::size_t end = tokens.isMark(i, '{') ? tokens.find(i + 1, "}") : i;
    std::size_t cases = 0;
    for (; i < end; ++i) cases += std::size_t(isIdentifier(tokens[i], "case"));
    if (cases > limits::kSwitchCases) return found;
  }
  return nullptr;
}

}  // namespace

void checkStageSize(const TokenStream& stream, Diagnostics& diagnostics) {
  const CodeTokens tokens(stream.tokens);
  const auto report = [&](const Token* at, std::string message) {
    if (!at) return;
    diagnostics.push_back({.severity = Severity::Error,
                           .id = "stage-too-large",
                           .at = locate(stream.sites, at->origin),
                           .message = std::move(message),
                           .includedFrom = includedFrom(stream.sites, at->origin.site)});
  };
  if (const Token* const name = InlinedSizes(tokens).tooLarge())
    report(name, fmt::format("function {} has more than {} tokens with the functions that it calls in their places",
                             name->text, limits::kInlinedTokens));
  if (const Token* const name = ArrayLengths(tokens).tooLarge())
    report(name, fmt::format("{} has more than {} elements", name->text, limits::kArrayElements));
  report(tooManyCases(tokens), fmt::format("a switch has more than {} cases", limits::kSwitchCases));
}

}  // namespace orris
