#include "glsl/brace_check.h"

#include <algorithm>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "glsl/text_tokens.h"

namespace orris {
namespace {

bool isFlowWord(const std::string& word) {
  return word == "if" || word == "for" || word == "while" || word == "switch" || word == "else" ||
         word == "return";
}

/// A token with what the author's layout says of it.
struct LaidOut {
  const Token* token;
  bool firstOfLine = false;
  int indent = 0;     ///< of its line
  int statement = 0;  ///< indent of the line where its statement starts
};

class Layout {
 public:
  Layout(const MappedText& text, const SourceLines& lines) : text_(text), lines_(lines) {}

  std::vector<LaidOut> read(const std::vector<Token>& tokens) {
    std::vector<LaidOut> result;
    int parentheses = 0;
    bool starts = true;
    for (const Token& token : tokens) {
      LaidOut& entry = result.emplace_back(place(token));
      if (starts) statement_ = entry.indent;
      entry.statement = statement_;
      if (token.text == "(") ++parentheses;
      if (token.text == ")") parentheses = std::max(0, parentheses - 1);
      const bool brace = token.text == "{" || token.text == "}";
      if (brace) parentheses = 0;
      starts = brace || (token.text == ";" && parentheses == 0);
    }
    return result;
  }

 private:
  // Text of a macro or of the host has no layout of its own: it goes on with the line before.
  LaidOut place(const Token& token) {
    const SourceLocation at = text_.locate(token.origin.line, token.origin.column);
    const bool written = text_.macroIndexAt(token.origin.line, token.origin.column) < 0;
    if (at.file.empty() || !written) return {&token, false, indent_};
    const bool first = at.file != file_ || at.line != line_;
    if (first) indent_ = indentOf(at);
    file_ = at.file;
    line_ = at.line;
    return {&token, first, indent_};
  }

  int indentOf(const SourceLocation& at) const {
    constexpr int kTab = 4;
    const std::string line = lines_ ? lines_(at.file, at.line) : "";
    if (line.empty()) return at.column - 1;
    int width = 0;
    for (const char c : line) {
      if (c != ' ' && c != '\t') break;
      width = c == '\t' ? (width / kTab + 1) * kTab : width + 1;
    }
    return width;
  }

  const MappedText& text_;
  const SourceLines& lines_;
  std::string file_;
  int line_ = 0, indent_ = 0, statement_ = 0;
};

using Part = std::span<const LaidOut>;

bool is(const LaidOut& entry, std::string_view text) { return entry.token->text == text; }

// "type name ( ... ) {": nothing else looks like it.
bool startsFunction(Part tokens, std::size_t at) {
  if (at + 2 >= tokens.size() || !is(tokens[at + 2], "(")) return false;
  for (const std::size_t i : {at, at + 1}) {
    if (tokens[i].token->kind != TokenKind::Identifier || isFlowWord(tokens[i].token->text))
      return false;
  }
  int depth = 0;
  for (std::size_t i = at + 2; i < tokens.size(); ++i) {
    if (is(tokens[i], "{") || is(tokens[i], ";")) return false;
    depth += is(tokens[i], "(") ? 1 : is(tokens[i], ")") ? -1 : 0;
    if (depth == 0) return i + 1 < tokens.size() && is(tokens[i + 1], "{");
  }
  return false;
}

/// The text from one function to the next.
std::vector<Part> splitByFunction(Part tokens) {
  std::vector<Part> parts;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (i == begin || !startsFunction(tokens, i)) continue;
    parts.push_back(tokens.subspan(begin, i - begin));
    begin = i;
  }
  parts.push_back(tokens.subspan(begin));
  return parts;
}

// Braces that a stack pairs, -1 for the missing one.
using Pairs = std::vector<std::pair<int, int>>;

Pairs pairBraces(Part part) {
  Pairs pairs;
  std::vector<int> open;
  for (int i = 0; i < int(part.size()); ++i) {
    if (is(part[size_t(i)], "{")) open.push_back(i);
    if (!is(part[size_t(i)], "}")) continue;
    pairs.emplace_back(open.empty() ? -1 : open.back(), i);
    if (!open.empty()) open.pop_back();
  }
  for (const int i : open) pairs.emplace_back(i, -1);
  return pairs;
}

MissingBrace missingClose(Part part, const Pairs& pairs) {
  const auto isDeeper = [part](const std::pair<int, int>& pair) {
    if (pair.first < 0 || pair.second < 0) return pair.first >= 0;
    const LaidOut& close = part[size_t(pair.second)];
    return close.firstOfLine && part[size_t(pair.first)].statement > close.indent;
  };
  const auto open = size_t(std::ranges::find_if(pairs, isDeeper)->first);
  const int limit = part[open].statement;
  // A line that stands further left than the first one inside is outside.
  int inside = -1;
  for (std::size_t i = open + 1; i < part.size(); ++i) {
    if (!part[i].firstOfLine) continue;
    if (inside < 0 && part[i].indent > limit) inside = part[i].indent;
    if (part[i].indent <= limit || part[i].indent < inside) {
      return {'}', *part[i - 1].token, *part[open].token};
    }
  }
  return {'}', *part.back().token, *part[open].token};
}

MissingBrace missingOpen(Part part, const Pairs& pairs) {
  const auto isDeeper = [part](const std::pair<int, int>& pair) {
    if (pair.first < 0 || pair.second < 0) return pair.second >= 0;
    const LaidOut& close = part[size_t(pair.second)];
    return close.firstOfLine && part[size_t(pair.first)].statement < close.indent;
  };
  const auto close = size_t(std::ranges::find_if(pairs, isDeeper)->second);
  // The line before the indented ones is where the block starts.
  std::size_t last = close;
  for (std::size_t i = close; i-- > 0;) {
    if (part[i].indent <= part[close].indent) {
      last = i;
      break;
    }
  }
  return {'{', *part[last].token, *part[close].token};
}

}  // namespace

std::optional<MissingBrace> findMissingBrace(const MappedText& text, const SourceLines& lines) {
  const std::vector<Token> tokens = tokensOf(text);
  const std::vector<LaidOut> layout = Layout(text, lines).read(tokens);
  for (const Part part : splitByFunction(layout)) {
    const Pairs pairs = pairBraces(part);
    int balance = 0;
    for (const auto& [open, close] : pairs) balance += close < 0 ? 1 : open < 0 ? -1 : 0;
    if (balance > 0) return missingClose(part, pairs);
    if (balance < 0) return missingOpen(part, pairs);
  }
  return std::nullopt;
}

}  // namespace orris
