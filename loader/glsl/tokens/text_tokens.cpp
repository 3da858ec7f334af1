#include <orris/glsl/tokens/text_tokens.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <iterator>
#include <map>
#include <span>
#include <string>

namespace orris {
namespace {

struct TokenName {
  std::string_view name, text;
};

// As glslang, and in quotes other compilers, name what they did not expect.
constexpr std::array<TokenName, 20> kPunctuators = {{
    {"SEMICOLON", ";"},  {"COMMA", ","},       {"LEFT_BRACE", "{"},   {"RIGHT_BRACE", "}"},
    {"LEFT_PAREN", "("}, {"RIGHT_PAREN", ")"}, {"LEFT_BRACKET", "["}, {"RIGHT_BRACKET", "]"},
    {"EQUAL", "="},      {"DOT", "."},         {"COLON", ":"},        {"QUESTION", "?"},
    {"PLUS", "+"},       {"DASH", "-"},        {"STAR", "*"},         {"SLASH", "/"},
    {"LEFT_ANGLE", "<"}, {"RIGHT_ANGLE", ">"}, {"BANG", "!"},         {"INC_OP", "++"},
}};

std::string lower(std::string_view text) {
  std::string result(text);
  std::ranges::transform(result, result.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return result;
}

// The word after "unexpected ", without quotes.
std::string_view unexpectedWord(std::string_view message) {
  constexpr std::string_view kBefore = "unexpected ";
  const std::size_t at = message.find(kBefore);
  if (at == std::string_view::npos) return {};
  std::string_view word = message.substr(at + kBefore.size());
  if (word.starts_with('\'')) return word.substr(1, word.find('\'', 1) - 1);
  return word.substr(0, word.find_first_of(", "));
}

bool mayBe(std::string_view word, const Token& token) {
  for (const TokenName& name : kPunctuators) {
    if (word == name.name || word == name.text) return token.text == name.text;
  }
  if (word.find("IDENTIFIER") != std::string_view::npos) return token.kind == TokenKind::Identifier;
  if (word.ends_with("CONSTANT")) return token.kind == TokenKind::Number;
  if (token.kind == TokenKind::Identifier) return lower(word) == lower(token.text);
  return false;
}

bool isOneOf(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::ranges::find(words, word) != words.end();
}

// Does the ")" at `close` end the head of a statement, "if (...)"?
bool closesHead(const std::vector<Token>& tokens, std::size_t close) {
  int depth = 0;
  for (std::size_t i = close + 1; i-- > 0;) {
    depth += tokens[i].text == ")" ? 1 : tokens[i].text == "(" ? -1 : 0;
    if (depth == 0) return i > 0 && isOneOf(tokens[i - 1].text, {"if", "for", "while", "switch"});
  }
  return false;
}

bool mayEndStatement(const std::vector<Token>& tokens, std::size_t index) {
  const Token& token = tokens[index];
  if (token.kind == TokenKind::Number || token.text == "]") return true;
  if (token.text == ")") return !closesHead(tokens, index);
  return token.kind == TokenKind::Identifier && !isOneOf(token.text, {"else", "do"});
}

/// "if (a" above a line that begins with "||": what is missing is missing below.
bool isHeadThatGoesOn(std::span<const Token> tokens, const Token& parenthesis) {
  const auto at = std::ranges::find_if(tokens, [&](const Token& token) {
    return token.origin.line == parenthesis.origin.line &&
           token.origin.column == parenthesis.origin.column;
  });
  if (at == tokens.begin() || at == tokens.end()) return false;
  const auto below = std::find_if(at, tokens.end(), [&](const Token& token) {
    return token.origin.line > parenthesis.origin.line;
  });
  return isOneOf(std::prev(at)->text, {"if", "while"}) && below != tokens.end() &&
         isOneOf(below->text, {"||", "&&", "==", "!=", "<", ">", "+", "-", "*", "/"});
}

/// Does the line before, blank ones left out, end a statement or a block?
bool beginsStatement(std::string_view text, int line) {
  std::size_t begin = 0;
  for (int i = 1; i < line; ++i) {
    const std::size_t end = text.find('\n', begin);
    if (end == text.npos) return false;
    begin = end + 1;
  }
  const std::size_t last = text.substr(0, begin).find_last_not_of(" \t\r\n");
  return last != text.npos && isOneOf(text.substr(last, 1), {";", "{", "}"});
}

}  // namespace

std::vector<Token> tokensOf(const MappedText& text) {
  // Directives stand at the head only.
  std::size_t at = 0;
  int line = 0;
  while (at < text.text.size() && text.text[at] == '#') {
    at = std::min(text.text.find('\n', at), text.text.size() - 1) + 1;
    ++line;
  }
  std::vector<Token> tokens = tokenize(std::string_view(text.text).substr(at));
  for (Token& token : tokens) token.origin.line += line;
  return tokens;
}

SourceLocation placeAfter(const MappedText& text, const Token& token) {
  SourceLocation at = text.locate(token.origin.line, token.origin.column);
  const bool written = text.macroIndexAt(token.origin.line, token.origin.column) < 0;
  if (!at.file.empty() && written) at.column += static_cast<int>(token.text.size());
  return at;
}

std::optional<Token> tokenBeforeGap(const MappedText& text, int line, std::string_view message) {
  if (message.find("syntax error") == std::string_view::npos) return std::nullopt;
  const std::vector<Token> tokens = tokensOf(text);
  if (tokens.empty()) return std::nullopt;
  if (line == 0 || message.find("end of file") != std::string_view::npos) return tokens.back();
  const auto found = std::ranges::find_if(
      tokens, [line](const Token& token) { return token.origin.line >= line; });
  if (found == tokens.begin() || found == tokens.end()) return std::nullopt;
  const auto before = static_cast<std::size_t>(found - tokens.begin()) - 1;
  const bool gap = found->origin.line == line && mayBe(unexpectedWord(message), *found) &&
                   mayEndStatement(tokens, before);
  return gap ? std::optional(tokens[before]) : std::nullopt;
}

std::optional<Token> unclosedParenthesis(const MappedText& text, int line,
                                         std::string_view message) {
  // A list that goes on inside of a call has too many arguments for it.
  const bool maybe = message.find("syntax error") != std::string_view::npos ||
                     message.find("too many arguments") != std::string_view::npos ||
                     message.find("no matching overloaded function") != std::string_view::npos;
  if (!maybe || beginsStatement(text.text, line)) return std::nullopt;
  const std::vector<Token> tokens = tokensOf(text);
  const auto ends = [](const Token& token) { return isOneOf(token.text, {";", "{", "}"}); };
  const auto end = std::ranges::find_if(
      tokens, [&](const Token& token) { return token.origin.line >= line && ends(token); });
  if (end == tokens.end() || end->origin.line != line) return std::nullopt;
  const auto begin = std::find_if(std::make_reverse_iterator(end), tokens.rend(), ends).base();
  // Where one line of many has more that open than that close, it lacks the one that closes; but one
  // that ends a line is meant to stay open.
  std::map<int, std::vector<Token>> open;
  int toStay = 0;
  for (auto token = begin; token != end; ++token) {
    std::vector<Token>& ofLine = open[token->origin.line];
    if (token->text == "(") {
      const bool endsLine = std::next(token)->origin.line > token->origin.line;
      toStay += endsLine ? 1 : 0;
      if (!endsLine) ofLine.push_back(*token);
    }
    if (token->text != ")") continue;
    if (ofLine.empty() && toStay-- == 0) return std::nullopt;
    if (!ofLine.empty()) ofLine.pop_back();
  }
  std::erase_if(open, [](const auto& entry) { return entry.second.empty(); });
  if (open.size() != 1) return std::nullopt;
  const Token& parenthesis = open.begin()->second.front();
  if (isHeadThatGoesOn(std::span(begin, end), parenthesis)) return std::nullopt;
  return parenthesis;
}

}  // namespace orris
