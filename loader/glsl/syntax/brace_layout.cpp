#include <orris/glsl/syntax/brace_layout.h>

#include <algorithm>
#include <map>
#include <string>

#include <orris/glsl/syntax/brace_check.h>

namespace orris {
namespace {

class Layout {
 public:
  Layout(const MappedText& text, const SourceLines& lines) : text_(text), lines_(lines) {}

  std::vector<LaidOut> read(const std::vector<Token>& tokens) {
    std::vector<LaidOut> result;
    std::vector<int> blocks;  // indents of those that are open
    int parentheses = 0;
    bool starts = true;
    for (const Token& token : tokens) {
      LaidOut& entry = result.emplace_back(place(token));
      // "} else" without its brace: what is left stands one blank further in.
      if (entry.firstOfLine && token.text == "else" && !blocks.empty() &&
          entry.indent == blocks.back() + 1)
        entry.indent = indent_ = blocks.back();
      if (starts) statement_ = entry.indent;
      entry.statement = statement_;
      if (token.text == "(") ++parentheses;
      if (token.text == ")") parentheses = std::max(0, parentheses - 1);
      const bool brace = token.text == "{" || token.text == "}";
      if (brace) parentheses = 0;
      if (token.text == "{") {
        entry.around = indentOfEndBelow();
        blocks.push_back(statement_);
      }
      if (token.text == "}" && !blocks.empty()) blocks.pop_back();
      starts = brace || (token.text == ";" && parentheses == 0);
    }
    return result;
  }

 private:
  // "#if A / if (x) { / #else / if (y) { / #endif": the block goes on outside.
  int indentOfEndBelow() const {
    const std::string below = lines_ ? lines_(file_, line_ + 1) : "";
    const std::size_t first = below.find_first_not_of(" \t");
    const bool ends = first != std::string::npos && below.compare(first, 2, "#e") == 0;
    return ends ? indentWidth(below) : -1;
  }

  // Text of a macro or of the host has no layout of its own: it goes on with the line before.
  LaidOut place(const Token& token) {
    const SourceLocation at = text_.locate(token.origin.line, token.origin.column);
    const bool written = text_.macroIndexAt(token.origin.line, token.origin.column) < 0;
    if (at.file.empty() || !written)
      return {&token, false, indent_, 0, -1, number_, token.origin.line};
    const bool first = at.file != file_ || at.line != line_;
    if (first) indent_ = indentOf(at);
    file_ = at.file;
    line_ = at.line;
    number_ = numbers_.try_emplace(file_, int(numbers_.size())).first->second;
    return {&token, first, indent_, 0, -1, number_, token.origin.line};
  }

  int indentOf(const SourceLocation& at) const {
    const std::string line = lines_ ? lines_(at.file, at.line) : "";
    return line.empty() ? at.column - 1 : indentWidth(line);
  }

  const MappedText& text_;
  const SourceLines& lines_;
  std::map<std::string, int> numbers_;
  std::string file_;
  int line_ = 0, indent_ = 0, statement_ = 0, number_ = 0;
};

}  // namespace

int indentWidth(std::string_view line) {
  constexpr int kTab = 4;
  int width = 0;
  for (const char c : line) {
    if (c != ' ' && c != '\t') break;
    width = c == '\t' ? (width / kTab + 1) * kTab : width + 1;
  }
  return width;
}

std::vector<LaidOut> readLayout(const std::vector<Token>& tokens, const MappedText& text,
                                const SourceLines& lines) {
  return Layout(text, lines).read(tokens);
}

}  // namespace orris
