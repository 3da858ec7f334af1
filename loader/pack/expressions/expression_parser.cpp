#include <orris/pack/expressions/expression_parser.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <numbers>

#include <orris/core/characters.h>
#include <orris/pack/files/text.h>

namespace orris {
namespace {

constexpr int kMostNodes = 8192;
constexpr int kDeepest = 64;

struct Operator {
  std::string_view token, name;
  int level;  ///< a lower level binds tighter
};
// A token stands before the shorter ones that it starts with. && and || have one level on purpose.
constexpr std::array<Operator, 16> kOperators{{{"*", "*", 1},
                                               {"/", "/", 1},
                                               {"%", "%", 1},
                                               {"+", "+", 2},
                                               {"-", "-", 2},
                                               {"==", "==", 3},
                                               {"!=", "!=", 3},
                                               {"<=", "<=", 3},
                                               {">=", ">=", 3},
                                               {"\u2260", "!=", 3},
                                               {"\u2264", "<=", 3},
                                               {"\u2265", ">=", 3},
                                               {"<", "<", 3},
                                               {">", ">", 3},
                                               {"&&", "&&", 4},
                                               {"||", "||", 4}}};
constexpr int kLoosest = 4;

std::optional<long long> parseWholeNumber(std::string_view text) {
  int base = 10;
  if (text.size() > 1 && text[0] == '0') {
    const char kind = static_cast<char>(text[1] | 0x20);
    base = kind == 'x' ? 16 : kind == 'b' ? 2 : 8;
    text.remove_prefix(base == 8 ? 1 : 2);
  }
  long long value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
  const bool whole = error == std::errc() && end == text.data() + text.size() && value <= INT32_MAX;
  return whole ? std::optional(value) : std::nullopt;
}

std::optional<Value> parseNumber(std::string_view text) {
  if (const auto whole = parseWholeNumber(text)) return Value::ofInt(static_cast<int>(*whole));
  if (const auto real = parseFloat(text)) return Value::ofFloat(*real);
  return std::nullopt;
}

std::optional<Value> constantNamed(std::string_view name) {
  if (name == "true" || name == "false") return Value::ofBool(name == "true");
  if (name == "pi") return Value::ofFloat(std::numbers::pi_v<float>);
  return std::nullopt;
}

class Parser {
 public:
  Parser(std::string_view text, ExpressionError& error) : text_(text), error_(error) {}

  std::optional<ExpressionTree> whole() {
    ExpressionTree tree = binary(kLoosest, 0);
    skipBlanks();
    if (!failed_ && at_ < text_.size()) fail("expected an operator or the end");
    return failed_ ? std::nullopt : std::optional(std::move(tree));
  }

 private:
  void skipBlanks() {
    while (at_ < text_.size() && static_cast<unsigned char>(text_[at_]) <= ' ') ++at_;
  }
  bool take(std::string_view token) {
    skipBlanks();
    if (!text_.substr(at_).starts_with(token)) return false;
    at_ += token.size();
    return true;
  }
  int column() const { return static_cast<int>(at_) + 1; }

  ExpressionTree fail(std::string message) {
    if (!failed_) error_ = {std::move(message), column()};
    failed_ = true;
    return {};
  }

  ExpressionTree node(ExpressionTree::Kind kind) {
    if (++nodes_ > kMostNodes) return fail(fmt::format("more than {} terms", kMostNodes));
    ExpressionTree tree;
    tree.kind = kind;
    tree.column = column();
    return tree;
  }

  ExpressionTree call(std::string_view name, int column, std::vector<ExpressionTree> arguments) {
    ExpressionTree tree = node(ExpressionTree::Kind::Call);
    tree.name = name;
    tree.column = column;
    tree.arguments = std::move(arguments);
    return tree;
  }

  const Operator* takeOperator(int level) {
    skipBlanks();
    const std::string_view rest = text_.substr(at_);
    for (const Operator& candidate : kOperators) {
      if (!rest.starts_with(candidate.token)) continue;
      if (candidate.level != level) return nullptr;
      at_ += candidate.token.size();
      return &candidate;
    }
    return nullptr;
  }

  ExpressionTree binary(int level, int depth) {
    if (level == 0) return unary(depth);
    ExpressionTree left = binary(level - 1, depth);
    while (!failed_) {
      skipBlanks();
      const int at = column();
      const Operator* found = takeOperator(level);
      if (!found) break;
      std::vector<ExpressionTree> sides;
      sides.push_back(std::move(left));
      sides.push_back(binary(level - 1, depth));
      left = call(found->name, at, std::move(sides));
    }
    return left;
  }

  ExpressionTree unary(int depth) {
    if (depth > kDeepest) return fail(fmt::format("nested deeper than {}", kDeepest));
    skipBlanks();
    const int at = column();
    for (const auto& [token, name] : {std::pair("!", "!"), std::pair("-", "neg")}) {
      if (!take(token)) continue;
      std::vector<ExpressionTree> operand;
      operand.push_back(unary(depth + 1));
      return call(name, at, std::move(operand));
    }
    if (take("(")) {
      ExpressionTree inner = binary(kLoosest, depth + 1);
      return failed_ || take(")") ? std::move(inner) : fail("expected )");
    }
    return primary(depth);
  }

  ExpressionTree primary(int depth) {
    if (at_ >= text_.size()) return fail("the expression ends too early");
    if (isDigit(text_[at_]) || text_[at_] == '.') return number();
    const std::string_view word = leadingWord(text_.substr(at_));
    if (word.empty()) return fail(fmt::format("unexpected character {}", text_[at_]));
    ExpressionTree tree = node(ExpressionTree::Kind::Name);
    at_ += word.size();
    tree.name = word;
    if (take("(")) {
      tree.kind = ExpressionTree::Kind::Call;
      return arguments(std::move(tree), depth);
    }
    if (const auto constant = constantNamed(word)) {
      tree.kind = ExpressionTree::Kind::Literal;
      tree.literal = *constant;
      return tree;
    }
    while (take(".")) {
      skipBlanks();
      const std::string_view access = leadingWord(text_.substr(at_));
      if (access.empty()) return fail("expected an element like x after the dot");
      tree.accesses.emplace_back(access);
      at_ += access.size();
    }
    return tree;
  }

  ExpressionTree number() {
    ExpressionTree tree = node(ExpressionTree::Kind::Literal);
    size_t end = at_;
    while (end < text_.size() && (isWordCharacter(text_[end]) || text_[end] == '.')) ++end;
    const std::string_view digits = text_.substr(at_, end - at_);
    const auto value = parseNumber(digits);
    if (!value) return fail(fmt::format("\"{}\" is no number", digits));
    tree.literal = *value;
    at_ = end;
    return tree;
  }

  ExpressionTree arguments(ExpressionTree tree, int depth) {
    while (!take(")")) {
      tree.arguments.push_back(binary(kLoosest, depth + 1));
      if (failed_) return tree;
      // The last comma may stand before the parenthesis.
      if (!take(",")) return take(")") ? std::move(tree) : fail("expected , or )");
    }
    return tree;
  }

  std::string_view text_;
  ExpressionError& error_;
  size_t at_ = 0;
  int nodes_ = 0;
  bool failed_ = false;
};

}  // namespace

std::optional<ExpressionTree> parseExpression(std::string_view text, ExpressionError& error) {
  return Parser(text, error).whole();
}

}  // namespace orris
