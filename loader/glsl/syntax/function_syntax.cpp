#include <orris/glsl/syntax/function_syntax.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include <orris/glsl/tokens/outline.h>
#include <orris/glsl/tokens/token.h>

namespace orris {
namespace {

constexpr std::array<std::string_view, 31> kInfix = {
    "=",  "+=", "-=", "*=", "/=", "%=", "<<=", ">>=", "&=", "^=", "|=", "+",  "-",  "*",  "/", "%",
    "<<", ">>", "<",  ">",  "<=", ">=", "==",  "!=",  "&",  "^",  "|",  "&&", "||", "^^", ","};
constexpr std::array<std::string_view, 6> kPrefix = {"+", "-", "!", "~", "++", "--"};
// Words that are no name, no type and no operand.
constexpr std::array<std::string_view, 13> kStatementWords = {
    "if",      "else",   "for",   "while",   "do",       "switch", "case",
    "default", "return", "break", "discard", "continue", "struct"};

template <typename List>
bool contains(const List& list, std::string_view text) {
  return std::find(list.begin(), list.end(), text) != list.end();
}

// Deeper nesting is refused rather than followed: untrusted text must not exhaust the stack.
constexpr int kDeepest = 200;

/// Each read...() consumes what it names, or notes the first mistake and returns false.
class SyntaxReader {
 public:
  explicit SyntaxReader(std::string_view text) : text_(text), tokens_(codeTokens(text)) {}

  std::optional<SyntaxMistake> run() {
    while (at_ < tokens_.size() && readFunction()) continue;
    return std::move(mistake_);
  }

 private:
  static std::vector<Token> codeTokens(std::string_view text) {
    std::vector<Token> tokens;
    tokenizeFrom(text, 0, tokens);
    std::erase_if(tokens, [](const Token& token) { return token.kind == TokenKind::Comment; });
    return tokens;
  }

  const Token* token(std::size_t ahead = 0) const {
    return at_ + ahead < tokens_.size() ? &tokens_[at_ + ahead] : nullptr;
  }
  bool is(std::string_view text, std::size_t ahead = 0) const {
    return token(ahead) && token(ahead)->text == text;
  }
  bool isName(std::size_t ahead = 0) const {
    return token(ahead) && token(ahead)->kind == TokenKind::Identifier &&
           !contains(kStatementWords, token(ahead)->text);
  }
  bool take(std::string_view text) {
    if (!is(text)) return false;
    ++at_;
    return true;
  }

  bool fail(std::string_view expected) {
    if (mistake_) return false;
    const std::string found = token() ? fmt::format("'{}'", token()->text) : "the end of it";
    mistake_ = {token() ? static_cast<std::size_t>(token()->origin.column - 1) : text_.size(),
                fmt::format("syntax error: expected {} before {}", expected, found)};
    return false;
  }
  bool expect(std::string_view text) { return take(text) || fail(fmt::format("'{}'", text)); }

  bool readFunction() {
    skipQualifiers();
    if (!readType()) return false;
    if (!isName()) return fail("the name of a function");
    ++at_;
    return expect("(") && readParameters() && expect("{") && readBlock();
  }

  void skipQualifiers() {
    while (token() && isQualifier(token()->text)) {
      ++at_;
      if (is("(")) skipBrackets();
    }
  }

  void skipBrackets() {
    int depth = 0;
    do {
      depth += is("(") ? 1 : is(")") ? -1 : 0;
      ++at_;
    } while (token() && depth > 0);
  }

  bool readType() {
    if (take("struct")) {
      if (isName()) ++at_;
      return expect("{") && readMembers() && readDimensions();
    }
    if (!isName()) return fail("a type");
    ++at_;
    return readDimensions();
  }

  bool readMembers() {
    while (!take("}")) {
      skipQualifiers();
      if (!readType() || !readDeclarators()) return false;
    }
    return true;
  }

  bool readDimensions() {
    while (take("[")) {
      if (!take("]") && !(readExpression() && expect("]"))) return false;
    }
    return true;
  }

  bool readParameters() {
    if (take(")")) return true;
    do {
      skipQualifiers();
      if (!readType()) return false;
      if (isName()) ++at_;
      if (!readDimensions()) return false;
    } while (take(","));
    return expect(")");
  }

  /// After "{".
  bool readBlock() {
    while (!take("}")) {
      if (!token()) return fail("'}'");
      if (!readStatement()) return false;
    }
    return true;
  }

  bool readStatement() {
    const Depth deeper(depth_);
    if (depth_ > kDeepest) return fail("fewer blocks in each other");
    if (take(";")) return true;
    if (take("{")) return readBlock();
    if (take("if")) {
      if (!readCondition() || !readStatement()) return false;
      return !take("else") || readStatement();
    }
    if (take("while")) return readCondition() && readStatement();
    if (take("for")) return readFor();
    if (take("do")) {
      return readStatement() && expect("while") && readCondition() && expect(";");
    }
    if (take("switch")) return readCondition() && expect("{") && readBlock();
    if (take("case")) return readExpression() && expect(":");
    if (take("default")) return expect(":");
    if (take("return")) return take(";") || (readExpression() && expect(";"));
    if (take("break") || take("continue") || take("discard")) return expect(";");
    if (take("precision")) return readWords(2);
    return readSimple();
  }

  /// "highp float;"
  bool readWords(int count) {
    for (; count > 0; --count) {
      if (!token() || token()->kind != TokenKind::Identifier) return fail("a precision");
      ++at_;
    }
    return expect(";");
  }

  bool readCondition() {
    if (!expect("(")) return false;
    if (declares()) {
      skipQualifiers();
      if (!readType() || !readDeclarator()) return false;
    } else if (!readExpression()) {
      return false;
    }
    return expect(")");
  }

  bool readFor() {
    if (!expect("(") || !(take(";") || readSimple())) return false;
    if (!take(";")) {
      if (!(declares() ? readType() && readDeclarator() : readExpression())) return false;
      if (!expect(";")) return false;
    }
    return take(")") || (readExpression() && expect(")"));
  }

  /// A declaration, or an expression, and ";".
  bool readSimple() {
    if (!declares()) return readExpression() && expect(";");
    skipQualifiers();
    if (take(";")) return true;
    return readType() && (take(";") || readDeclarators());
  }

  /// Qualifiers, "struct", or "type name", "type[2] name".
  bool declares() const {
    if (token() && (isQualifier(token()->text) || is("struct"))) return true;
    if (!isName()) return false;
    std::size_t ahead = 1;
    while (is("[", ahead)) {
      int depth = 0;
      do {
        depth += is("[", ahead) ? 1 : is("]", ahead) ? -1 : 0;
        ++ahead;
      } while (token(ahead) && depth > 0);
    }
    return isName(ahead);
  }

  bool readDeclarators() {
    do {
      if (!readDeclarator()) return false;
    } while (take(","));
    return expect(";");
  }

  bool readDeclarator() {
    if (!isName()) return fail("a name");
    ++at_;
    return readDimensions() && (!take("=") || readInitialiser());
  }

  bool readInitialiser() {
    const Depth deeper(depth_);
    if (depth_ > kDeepest) return fail("fewer lists in each other");
    if (!take("{")) return readExpression(false);
    while (!take("}")) {
      if (!readInitialiser()) return false;
      if (!take(",") && !is("}")) return fail("',' or '}'");
    }
    return true;
  }

  /// Operands with operators between them: which binds closer says nothing about whether it is right.
  bool readExpression(bool comma = true) {
    const Depth deeper(depth_);
    if (depth_ > kDeepest) return fail("fewer brackets in each other");
    for (;;) {
      if (!readOperand()) return false;
      if (take("?")) {
        if (!readExpression() || !expect(":")) return false;
        continue;
      }
      if (!token() || !contains(kInfix, token()->text) || (!comma && is(","))) return true;
      ++at_;
    }
  }

  bool readOperand() {
    while (token() && contains(kPrefix, token()->text)) ++at_;
    if (take("(")) {
      if (!readExpression() || !expect(")")) return false;
    } else if (isName() || (token() && token()->kind == TokenKind::Number)) {
      ++at_;
    } else {
      return fail("an expression");
    }
    return readSuffixes();
  }

  bool readSuffixes() {
    for (;;) {
      if (take("++") || take("--")) continue;
      if (take(".")) {
        if (!isName()) return fail("the name of a member");
        ++at_;
      } else if (take("[")) {
        if (!take("]") && !(readExpression() && expect("]"))) return false;
      } else if (take("(")) {
        if (!take(")") && !(readExpression() && expect(")"))) return false;
      } else {
        return true;
      }
    }
  }

  struct Depth {
    explicit Depth(int& counter) : depth(counter) { ++depth; }
    ~Depth() { --depth; }
    int& depth;
  };

  std::string_view text_;
  std::vector<Token> tokens_;
  std::size_t at_ = 0;
  int depth_ = 0;
  std::optional<SyntaxMistake> mistake_;
};

}  // namespace

std::optional<SyntaxMistake> findSyntaxMistake(std::string_view functions) {
  return SyntaxReader(functions).run();
}

}  // namespace orris
