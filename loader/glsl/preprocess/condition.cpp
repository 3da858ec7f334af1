#include <orris/glsl/preprocess/condition.h>

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string_view>
#include <utility>

namespace orris {
namespace {

// Deep enough for any real condition; bounds the stack on hostile input.
constexpr int kMaxDepth = 200;

struct BinaryOperator {
  std::string_view text;
  int precedence;
};

constexpr std::array<BinaryOperator, 18> kOperators = {{
    {"||", 1},
    {"&&", 2},
    {"|", 3},
    {"^", 4},
    {"&", 5},
    {"==", 6},
    {"!=", 6},
    {"<", 7},
    {">", 7},
    {"<=", 7},
    {">=", 7},
    {"<<", 8},
    {">>", 8},
    {"+", 9},
    {"-", 9},
    {"*", 10},
    {"/", 10},
    {"%", 10},
}};

std::int64_t numberValue(std::string_view text) {
  int base = 10;
  if (text.size() > 1 && text[0] == '0' && (text[1] | 0x20) == 'x') {
    base = 16;
    text.remove_prefix(2);
  } else if (text.find_first_of(".eE") != std::string_view::npos) {
    const double value = std::strtod(std::string(text).c_str(), nullptr);
    constexpr double kLimit = 9.0e18;
    return std::abs(value) < kLimit ? static_cast<std::int64_t>(value) : 0;
  } else if (text.size() > 1 && text[0] == '0') {
    base = 8;
  }
  std::uint64_t value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value, base);
  return static_cast<std::int64_t>(value);
}

// Arithmetic wraps, as it does in the preprocessors packs were tested with.
std::int64_t wrap(std::uint64_t value) { return static_cast<std::int64_t>(value); }

class Evaluator {
 public:
  explicit Evaluator(const std::vector<Token>& tokens) : tokens_(tokens) {}

  ConditionResult run() {
    result_.value = conditional(true);
    result_.used = position_;
    return result_;
  }

 private:
  const Token* peek() const { return position_ < tokens_.size() ? &tokens_[position_] : nullptr; }

  bool accept(std::string_view text) {
    const Token* token = peek();
    if (!token || token->kind != TokenKind::Punctuator || token->text != text) return false;
    ++position_;
    return true;
  }

  std::int64_t fail(std::string problem) { return fail(std::move(problem), position_); }

  std::int64_t fail(std::string problem, std::size_t at) {
    if (result_.problem.empty()) {
      result_.problem = std::move(problem);
      result_.problemAt = at;
    }
    position_ = tokens_.size();
    return 0;
  }

  // `live` is false in an operand whose value is not needed.
  std::int64_t conditional(bool live) {
    const std::int64_t condition = binary(1, live);
    if (!accept("?")) return condition;
    if (++depth_ > kMaxDepth) return fail("expression is nested too deeply");
    const std::int64_t yes = conditional(live && condition);
    if (!accept(":")) return fail("expected ':' after '?'");
    const std::int64_t no = conditional(live && !condition);
    --depth_;
    return condition ? yes : no;
  }

  const BinaryOperator* operatorAt() const {
    const Token* token = peek();
    if (!token || token->kind != TokenKind::Punctuator) return nullptr;
    for (const BinaryOperator& op : kOperators) {
      if (op.text == token->text) return &op;
    }
    return nullptr;
  }

  std::int64_t binary(int precedence, bool live) {
    std::int64_t left = unary(live);
    while (const BinaryOperator* op = operatorAt()) {
      if (op->precedence < precedence) break;
      const std::size_t at = position_++;
      const bool needed = op->text == "&&" ? left != 0 : op->text == "||" ? left == 0 : true;
      const std::int64_t right = binary(op->precedence + 1, live && needed);
      if (right == 0 && live && (op->text == "/" || op->text == "%")) {
        return fail("division by zero", at);
      }
      left = apply(op->text, left, right);
    }
    return left;
  }

  static std::int64_t divide(std::string_view op, std::int64_t left, std::int64_t right) {
    if (right == 0) return 0;
    const bool overflow = left == std::numeric_limits<std::int64_t>::min() && right == -1;
    if (op == "/") return overflow ? left : left / right;
    return overflow ? 0 : left % right;
  }

  static std::int64_t apply(std::string_view op, std::int64_t left, std::int64_t right) {
    const auto l = static_cast<std::uint64_t>(left);
    const auto r = static_cast<std::uint64_t>(right);
    if (op == "||") return left || right;
    if (op == "&&") return left && right;
    if (op == "==") return left == right;
    if (op == "!=") return left != right;
    if (op == "<=") return left <= right;
    if (op == ">=") return left >= right;
    if (op == "<<") return wrap(l << (r & 63));
    if (op == ">>") return left >> (r & 63);
    switch (op.front()) {
      case '<':
        return left < right;
      case '>':
        return left > right;
      case '|':
        return wrap(l | r);
      case '^':
        return wrap(l ^ r);
      case '&':
        return wrap(l & r);
      case '+':
        return wrap(l + r);
      case '-':
        return wrap(l - r);
      case '*':
        return wrap(l * r);
      default:
        return divide(op, left, right);
    }
  }

  std::int64_t unary(bool live) {
    if (++depth_ > kMaxDepth) return fail("expression is nested too deeply");
    std::int64_t value = 0;
    if (accept("!")) {
      value = !unary(live);
    } else if (accept("-")) {
      value = wrap(0 - static_cast<std::uint64_t>(unary(live)));
    } else if (accept("+")) {
      value = unary(live);
    } else if (accept("~")) {
      value = ~unary(live);
    } else {
      value = primary(live);
    }
    --depth_;
    return value;
  }

  std::int64_t primary(bool live) {
    if (accept("(")) {
      const std::int64_t value = conditional(live);
      return accept(")") || !result_.problem.empty() ? value : fail("expected ')'");
    }
    const Token* token = peek();
    if (!token) return fail("expected a value at the end of the expression");
    if (token->kind != TokenKind::Number && token->kind != TokenKind::Identifier) {
      return fail(fmt::format("expected a value, found '{}'", token->text));
    }
    ++position_;
    return token->kind == TokenKind::Number ? numberValue(token->text) : 0;
  }

  const std::vector<Token>& tokens_;
  std::size_t position_ = 0;
  int depth_ = 0;
  ConditionResult result_;
};

}  // namespace

ConditionResult evaluateCondition(const std::vector<Token>& tokens) {
  return Evaluator(tokens).run();
}

}  // namespace orris
