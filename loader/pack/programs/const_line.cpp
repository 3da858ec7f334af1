#include <orris/pack/programs/const_line.h>

#include <algorithm>
#include <array>
#include <optional>

#include <orris/pack/files/text.h>

namespace orris {
namespace {

constexpr std::array<std::string_view, 6> kConstTypes{"int",  "float", "bool",
                                                      "vec2", "ivec3", "vec4"};

bool isType(std::string_view word) {
  return std::find(kConstTypes.begin(), kConstTypes.end(), word) != kConstTypes.end();
}

/// Takes "const" with the blanks after it off `text`, or returns false.
bool takeWord(std::string_view& text, std::string& word) {
  word = leadingWord(text);
  text.remove_prefix(word.size());
  const std::string_view rest = trim(text);
  const bool separated = rest.size() != text.size();
  text = rest;
  return separated || rest.starts_with('=');
}

std::optional<ConstLine> parseText(std::string_view line) {
  std::string_view rest = trim(line);
  std::string keyword;
  ConstLine result;
  if (!takeWord(rest, keyword) || keyword != "const" || !takeWord(rest, result.type) ||
      !isType(result.type) || !takeWord(rest, result.name) || !rest.starts_with('=')) {
    return std::nullopt;
  }
  const size_t semicolon = rest.find(';');
  if (result.name.empty() || semicolon == std::string_view::npos) return std::nullopt;
  result.value = trim(rest.substr(1, semicolon - 1));
  result.sourceLine = line;
  return result;
}

void findInComment(const Token& comment, std::vector<ConstLine>& found) {
  const auto lines = splitAt(comment.text, '\n');
  // The first piece starts with the comment opener and so is no const line.
  for (size_t i = 1; i < lines.size(); ++i) {
    if (auto line = parseText(lines[i])) {
      line->origin = {comment.origin.site, comment.origin.line + static_cast<int>(i),
                      static_cast<int>(lines[i].find("const")) + 1};
      found.push_back(std::move(*line));
    }
  }
}

/// The declaration that starts with the const at `index`, all on one line.
std::optional<ConstLine> parseTokens(const std::vector<Token>& tokens, size_t index) {
  std::string text = tokens[index].text;
  for (size_t i = index + 1; i < tokens.size() && tokens[i].newlinesBefore == 0; ++i) {
    if (tokens[i].kind == TokenKind::Comment) continue;
    if (tokens[i].spaceBefore) text += ' ';
    text += tokens[i].text;
    if (tokens[i].text == ";") break;
  }
  auto line = parseText(text);
  if (line) line->origin = tokens[index].origin;
  return line;
}

}  // namespace

std::vector<ConstLine> findConstLines(const TokenStream& stream) {
  std::vector<ConstLine> found;
  const auto& tokens = stream.tokens;
  for (size_t i = 0; i < tokens.size(); ++i) {
    if (tokens[i].kind == TokenKind::Comment) {
      if (tokens[i].text.starts_with("/*")) findInComment(tokens[i], found);
    } else if (tokens[i].text == "const" && (i == 0 || tokens[i].newlinesBefore > 0)) {
      if (auto line = parseTokens(tokens, i)) found.push_back(std::move(*line));
    }
  }
  return found;
}

}  // namespace orris
