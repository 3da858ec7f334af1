#include <orris/glsl/syntax/syntax_message.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <vector>

#include <orris/glsl/tokens/text_tokens.h>

namespace orris {
namespace {

struct GrammarWord {
  std::string_view name, text;
};

// glslang: MachineIndependent/glslang.y. Other words are keywords in capitals.
constexpr std::array<GrammarWord, 38> kGrammarPunctuators{{
    {"SEMICOLON", ";"}, {"COMMA", ","}, {"COLON", ":"}, {"DOT", "."}, {"EQUAL", "="},
    {"QUESTION", "?"}, {"LEFT_PAREN", "("}, {"RIGHT_PAREN", ")"}, {"LEFT_BRACKET", "["},
    {"RIGHT_BRACKET", "]"}, {"LEFT_BRACE", "{"}, {"RIGHT_BRACE", "}"}, {"PLUS", "+"}, {"DASH", "-"},
    {"STAR", "*"}, {"SLASH", "/"}, {"PERCENT", "%"}, {"LEFT_ANGLE", "<"}, {"RIGHT_ANGLE", ">"},
    {"BANG", "!"}, {"TILDE", "~"}, {"AMPERSAND", "&"}, {"VERTICAL_BAR", "|"}, {"CARET", "^"},
    {"AND_OP", "&&"}, {"OR_OP", "||"}, {"XOR_OP", "^^"}, {"EQ_OP", "=="}, {"NE_OP", "!="},
    {"LE_OP", "<="}, {"GE_OP", ">="}, {"INC_OP", "++"}, {"DEC_OP", "--"}, {"LEFT_OP", "<<"},
    {"RIGHT_OP", ">>"}, {"ADD_ASSIGN", "+="}, {"SUB_ASSIGN", "-="}, {"MUL_ASSIGN", "*="},
}};

std::string_view punctuatorOf(std::string_view word) {
  const auto found = std::ranges::find(kGrammarPunctuators, word, &GrammarWord::name);
  return found == kGrammarPunctuators.end() ? std::string_view() : found->text;
}

std::string inLowerCase(std::string_view word) {
  std::string text(word);
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

bool isNumber(std::string_view word) { return word.ends_with("CONSTANT"); }
bool isName(std::string_view word) {
  return word == "IDENTIFIER" || word == "TYPE_NAME" || word == "FIELD_SELECTION";
}

/// A word of the grammar for people.
std::string describe(std::string_view word) {
  if (const std::string_view text = punctuatorOf(word); !text.empty())
    return fmt::format("'{}'", text);
  if (isNumber(word)) return "a number";
  if (isName(word)) return "a name";
  if (word == "$end" || word == "end") return "the end of the text";
  return fmt::format("'{}'", inLowerCase(word));
}

bool isA(const Token& token, std::string_view word) {
  if (const std::string_view text = punctuatorOf(word); !text.empty()) return token.text == text;
  if (isNumber(word)) return token.kind == TokenKind::Number;
  if (token.kind != TokenKind::Identifier) return false;
  return isName(word) || token.text == inLowerCase(word);
}

/// float, ivec2, mat4x3: a name may follow.
bool isTypeOfNumbers(std::string_view word) {
  constexpr std::array<std::string_view, 6> kScalars{"void", "bool", "int", "uint", "float", "double"};
  if (std::ranges::find(kScalars, word) != kScalars.end()) return true;
  const std::size_t size = word.find_first_of("234");
  if (size == word.npos || word.find_first_not_of("234x", size) != word.npos) return false;
  constexpr std::array<std::string_view, 7> kStems{"vec", "ivec", "uvec", "bvec", "dvec", "mat", "dmat"};
  return std::ranges::find(kStems, word.substr(0, size)) != kStems.end();
}

/// Can nothing but an operator or punctuator follow?
bool endsOperand(const Token& token) {
  if (token.kind != TokenKind::Identifier)
    return token.kind == TokenKind::Number || token.text == ")" || token.text == "]";
  return token.text != "return" && token.text != "else" && !isTypeOfNumbers(token.text);
}

/// The first token of the kind in the line that cannot follow what is before it, else the first.
const Token* findUnexpected(const std::vector<Token>& tokens, int line, std::string_view word) {
  const Token* first = nullptr;
  const bool operand = punctuatorOf(word).empty();
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (tokens[i].origin.line != line || !isA(tokens[i], word)) continue;
    if (!first) first = &tokens[i];
    if (!operand || (i > 0 && endsOperand(tokens[i - 1]))) return &tokens[i];
  }
  return first;
}

std::string_view wordAt(std::string_view text) {
  return text.substr(0, std::min(text.find_first_of(", "), text.size()));
}

/// The words behind "expecting". A comma may follow nearly everything: no one means it.
std::vector<std::string> expectedOf(std::string_view message) {
  constexpr std::string_view kExpecting = "expecting ";
  std::vector<std::string> expected;
  std::size_t at = message.find(kExpecting);
  while (at != std::string_view::npos) {
    at = message.find_first_not_of(' ', at + (expected.empty() ? kExpecting.size() : 4));
    if (at == std::string_view::npos) break;
    expected.emplace_back(wordAt(message.substr(at)));
    at = message.find(" or ", at);
  }
  if (expected.size() > 1) std::erase(expected, "COMMA");
  for (std::string& word : expected) word = describe(word);
  return expected;
}

}  // namespace

SyntaxMessage readSyntaxError(const MappedText& text, int line, std::string_view message) {
  constexpr std::string_view kUnexpected = "syntax error, unexpected ";
  const std::size_t at = message.find(kUnexpected);
  if (at == std::string_view::npos) return {};
  const std::string_view word = wordAt(message.substr(at + kUnexpected.size()));
  const std::vector<std::string> expected = expectedOf(message);
  const std::vector<Token> tokens = tokensOf(text);
  const Token* token = findUnexpected(tokens, line, word);
  const std::string found = token ? fmt::format("'{}'", token->text) : describe(word);
  SyntaxMessage result;
  result.column = token ? token->origin.column : 0;
  if (expected.empty()) {
    const bool operand = !punctuatorOf(word).empty();
    result.text = operand ? fmt::format("syntax error: expected an expression before {}", found)
                          : fmt::format("syntax error: {} cannot stand here", found);
    return result;
  }
  const std::string list = fmt::format("{}", fmt::join(expected, " or "));
  result.text = fmt::format("syntax error: expected {} before {}", list, found);
  result.behind = fmt::format("syntax error: expected {} after", list);
  return result;
}

}  // namespace orris
