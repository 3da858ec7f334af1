#include <orris/pack/expressions/boolean_expression.h>

#include <orris/pack/files/text.h>

namespace orris {
namespace {

constexpr int kDeepestCondition = 64;

class ConditionParser {
 public:
  ConditionParser(std::string_view text, const std::function<bool(std::string_view)>& valueOf)
      : rest_(text), valueOf_(valueOf) {}

  std::optional<bool> whole() {
    const bool value = either(0);
    return failed_ || !trim(rest_).empty() ? std::nullopt : std::optional(value);
  }

 private:
  bool take(std::string_view token) {
    rest_ = trim(rest_);
    if (!rest_.starts_with(token)) return false;
    rest_.remove_prefix(token.size());
    return true;
  }

  /// One sign is enough for Iris, which passes over the character after it. Iris: BooleanParser.
  bool takeOperator(std::string_view sign) {
    if (!take(sign)) return false;
    if (!rest_.empty()) rest_.remove_prefix(1);
    return true;
  }

  bool either(int depth) {
    bool value = both(depth);
    while (!failed_ && takeOperator("|")) value = both(depth) || value;
    return value;
  }

  bool both(int depth) {
    bool value = single(depth);
    while (!failed_ && takeOperator("&")) value = single(depth) && value;
    return value;
  }

  bool single(int depth) {
    if (depth > kDeepestCondition) return fail();
    if (take("!")) return !single(depth + 1);
    if (take("(")) {
      const bool value = either(depth + 1);
      return take(")") ? value : fail();
    }
    const std::string_view name = leadingWord(rest_);
    rest_.remove_prefix(name.size());
    if (name.empty()) return fail();
    if (const auto literal = parseBoolean(name)) return *literal;
    return valueOf_(name);
  }

  bool fail() {
    failed_ = true;
    return true;
  }

  std::string_view rest_;
  const std::function<bool(std::string_view)>& valueOf_;
  bool failed_ = false;
};

}  // namespace

std::optional<bool> evaluateCondition(std::string_view text,
                                      const std::function<bool(std::string_view)>& valueOf) {
  return ConditionParser(text, valueOf).whole();
}

}  // namespace orris
