// Where an author should write a brace that is missing.
#include <algorithm>

#include <orris/glsl/syntax/brace_check.h>
#include <orris/glsl/tokens/text_tokens.h>

namespace orris {
namespace {

/// What a line does to the number of open conditionals.
int conditionalStep(std::string_view line) {
  const std::size_t hash = line.find_first_not_of(" \t");
  if (hash == std::string_view::npos || line[hash] != '#') return 0;
  line.remove_prefix(std::min(line.find_first_not_of(" \t", hash + 1), line.size()));
  return line.starts_with("if") ? 1 : line.starts_with("endif") ? -1 : 0;
}

/// The end of the conditionals that hold `at` and not the line `from` before it.
SourceLocation behindConditionals(SourceLocation at, int from, const SourceLines& lines) {
  constexpr int kMostLines = 4096;
  if (at.line - from > kMostLines) return at;
  int open = 0;
  for (int line = from; line <= at.line; ++line)
    open = std::max(0, open + conditionalStep(lines(at.file, line)));
  SourceLocation end = at;
  for (int left = kMostLines; open > 0 && left > 0; --left) {
    const std::string line = lines(end.file, ++end.line);
    open += conditionalStep(line);
    end.column = int(line.size()) + 1;
  }
  return open == 0 ? end : at;
}

bool startsWithElse(std::string_view text) {
  constexpr std::string_view kElse = "else";
  return text.starts_with(kElse) && (text.size() == kElse.size() || text[kElse.size()] == ' ' ||
                                     text[kElse.size()] == '{' || text[kElse.size()] == '\r');
}

/// Text of an #include does not end a block of the file around it: the line behind the #include does.
SourceLocation inFileOf(const SourceLocation& partner, const SourceLocation& at,
                        const std::vector<SourceLocation>& includedFrom, const SourceLines& lines) {
  if (partner.file == at.file) return at;
  const auto from = std::ranges::find(includedFrom, partner.file, &SourceLocation::file);
  if (from == includedFrom.end() || from->line < partner.line) return at;
  return {from->file, from->line, int(lines(from->file, from->line).size()) + 1};
}

}  // namespace

SourceLocation placeOfBrace(const MappedText& text, const MissingBrace& missing,
                            const SourceLines& lines) {
  SourceLocation at = placeAfter(text, missing.after);
  if (missing.brace == '{' || !lines) return at;
  const SourceLocation partner =
      text.locate(missing.partner.origin.line, missing.partner.origin.column);
  const Origin& after = missing.after.origin;
  at = inFileOf(partner, at, text.includedFrom(after.line, after.column), lines);
  if (partner.file == at.file) at = behindConditionals(at, partner.line, lines);
  constexpr int kLongGap = 3, kMostBlank = 8;  // the end of a file reads as blank
  SourceLocation next = at;
  for (int blank = 0; blank < kMostBlank;) {
    const std::string line = lines(next.file, ++next.line);
    next.column = int(line.size()) + 1;
    const std::size_t first = line.find_first_not_of(" \t\r");
    if (first == std::string::npos) {
      ++blank;
      // White space as wide as the block is indented is what is left of a line without its brace.
      if (missing.indent > 0 && indentWidth(line) == missing.indent) return next;
    } else if (line[first] == '#' && indentWidth(line) > missing.indent) {
      at = next;
      blank = 0;
    } else if (startsWithElse(std::string_view(line).substr(first))) {
      return {next.file, next.line, int(first) + 1};
    } else {
      // In a gap that is too long the line of the brace is one of the blank ones.
      if (blank >= kLongGap) at = {at.file, at.line + (blank + 1) / 2, 1};
      break;
    }
  }
  return at;
}

}  // namespace orris
