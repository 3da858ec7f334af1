#include "glsl/syntax/brace_check.h"

#include <algorithm>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "glsl/syntax/nesting.h"
#include "glsl/tokens/text_tokens.h"

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
  int around = -1;    ///< of a '{' before an #else or #endif: the indent of that
  int file = 0;       ///< number of its file
  int row = 0;        ///< of the text
};

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

using Part = std::span<const LaidOut>;

bool isMark(const LaidOut& entry, std::string_view text) { return entry.token->text == text; }

// "type name ( ... ) {": nothing else looks like it.
bool startsFunction(Part tokens, std::size_t at) {
  if (at + 2 >= tokens.size() || !isMark(tokens[at + 2], "(")) return false;
  for (const std::size_t i : {at, at + 1}) {
    if (tokens[i].token->kind != TokenKind::Identifier || isFlowWord(tokens[i].token->text))
      return false;
  }
  int depth = 0;
  for (std::size_t i = at + 2; i < tokens.size(); ++i) {
    if (isMark(tokens[i], "{") || isMark(tokens[i], ";")) return false;
    depth += isMark(tokens[i], "(") ? 1 : isMark(tokens[i], ")") ? -1 : 0;
    if (depth == 0) return i + 1 < tokens.size() && isMark(tokens[i + 1], "{");
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

/// The word that begins the statement of the block at `at`: "if", "for", "else"; "" for functions,
/// types and values.
std::string_view headOf(Part part, std::size_t at) {
  if (at == 0) return "";
  std::size_t head = at - 1;
  if (isMark(part[head], ")")) {
    int depth = 0;
    for (std::size_t i = at; i-- > 1;) {
      depth += isMark(part[i], ")") ? 1 : isMark(part[i], "(") ? -1 : 0;
      head = i - 1;
      if (depth == 0) break;
    }
  }
  const std::string& word = part[head].token->text;
  return isFlowWord(word) || word == "do" ? std::string_view(word) : "";
}

/// The least indent of the lines of each file in a stretch without braces.
class Lowest {
 public:
  void add(const LaidOut& entry) {
    if (!entry.firstOfLine || isMark(entry, "{") || isMark(entry, "}")) return;
    int& lowest = indents_.try_emplace(entry.file, kNoLines).first->second;
    lowest = std::min(lowest, entry.indent);
  }
  int of(int file) const {
    const auto found = indents_.find(file);
    return found == indents_.end() ? kNoLines : found->second;
  }
  void clear() { indents_.clear(); }

 private:
  std::map<int, int> indents_;
};

std::vector<NestingMark> marksOf(Part part) {
  std::vector<NestingMark> marks;
  Lowest lowest;
  for (std::size_t i = 0; i < part.size(); ++i) {
    const LaidOut& entry = part[i];
    lowest.add(entry);
    const bool close = isMark(entry, "}");
    if (!close && !isMark(entry, "{")) continue;
    const std::string_view head = close ? "" : headOf(part, i);
    marks.push_back({.kind = close ? NestingMark::Kind::Close : NestingMark::Kind::Open,
                     .indent = !close              ? entry.statement
                               : entry.firstOfLine ? entry.indent
                                                   : -1,
                     .around = entry.around,
                     .group = entry.file,
                     .line = entry.row,
                     .inner = !head.empty(),
                     .mayElse = head == "if",
                     .hasElse = close && i + 1 < part.size() && isMark(part[i + 1], "else"),
                     .lowest = lowest.of(entry.file)});
    lowest.clear();
  }
  return marks;
}

/// A place in the nesting, and the token it is behind.
struct Candidates {
  std::vector<NestingPlace> places;
  std::vector<std::size_t> after;

  void add(const NestingPlace& place, std::size_t token) {
    places.push_back(place);
    after.push_back(token);
  }
};

// What speaks for a place beside the pairs.
constexpr int kBeforeElse = -6, kBehindHead = -6, kHeadInLine = -2, kNoHint = 2;
// Of two places that fit the one behind some text.
constexpr int kEmptyBlock = 1;

/// Completes the places with what stands between them and the next brace.
void addLinesBelow(Candidates& found, Part part) {
  Lowest lowest;
  std::size_t place = found.places.size();
  for (std::size_t i = part.size(); i-- > 0;) {
    for (; place > 0 && found.after[place - 1] == i; --place) {
      NestingPlace& above = found.places[place - 1];
      above.below = lowest.of(above.group);
    }
    lowest.add(part[i]);
    if (isMark(part[i], "{") || isMark(part[i], "}")) lowest.clear();
  }
}

/// Ends of lines where a block may end: the text goes back to the left, or goes on with an "else"
/// that stands below the head of the block.
Candidates placesToClose(Part part) {
  Candidates found;
  std::size_t braces = 0;
  std::map<int, int> indents;          // of the last line of each file
  std::vector<const LaidOut*> blocks;  // that are open
  bool opened = false;                 // in the last line
  Lowest lowest;
  for (std::size_t i = 0; i < part.size(); ++i) {
    const LaidOut& entry = part[i];
    if (entry.firstOfLine && i > 0) {
      const bool orElse = isMark(entry, "else") && !isMark(part[i - 1], "}") && !blocks.empty() &&
                          blocks.back()->file == entry.file &&
                          blocks.back()->statement == entry.indent;
      const auto last = indents.find(entry.file);
      if (opened || orElse || entry.file != part[i - 1].file || last == indents.end() ||
          entry.indent < last->second) {
        found.add({.before = braces,
                   .indent = entry.indent,
                   .group = entry.file,
                   .line = entry.row,
                   .cost = orElse                     ? kBeforeElse
                           : isMark(part[i - 1], "{") ? kEmptyBlock
                                                      : 0,
                   .above = lowest.of(entry.file),
                   .takesElse = isMark(entry, "else")},
                  i - 1);
      }
    }
    if (entry.firstOfLine) {
      indents[entry.file] = entry.indent;
      opened = false;
    }
    opened = opened || isMark(entry, "{");
    lowest.add(entry);
    if (isMark(entry, "{") || isMark(entry, "}")) lowest.clear();
    braces += isMark(entry, "{") || isMark(entry, "}") ? 1 : 0;
    if (isMark(entry, "{")) blocks.push_back(&entry);
    if (isMark(entry, "}") && !blocks.empty()) blocks.pop_back();
  }
  found.add({.before = braces, .line = part.back().row}, part.size() - 1);
  addLinesBelow(found, part);
  return found;
}

/// Ends of heads, "if (...)", "else" and "void main()", that no brace follows.
Candidates placesToOpen(Part part) {
  Candidates found;
  std::size_t braces = 0;
  int parentheses = 0;
  for (std::size_t i = 0; i < part.size(); ++i) {
    const LaidOut& entry = part[i];
    if (isMark(entry, "{") || isMark(entry, "}")) {
      ++braces;
      parentheses = 0;
    }
    parentheses += isMark(entry, "(") ? 1 : isMark(entry, ")") ? -1 : 0;
    const bool ends = i + 1 == part.size();
    const bool head = (isMark(entry, ")") && parentheses <= 0) || isMark(entry, "else");
    const bool names = !ends && part[i + 1].token->kind == TokenKind::Identifier;
    const bool newLine = ends || part[i + 1].firstOfLine;
    const bool goesOn = names && !(isMark(entry, "else") && isMark(part[i + 1], "if"));
    const bool inner = !ends && isMark(part[i + 1], "}");
    if (!(head && (goesOn || inner)) && !(newLine && !ends && part[i + 1].indent > entry.indent))
      continue;
    found.add({braces, entry.statement, entry.file, entry.row,
               head ? (newLine ? kBehindHead : kHeadInLine) : kNoHint},
              i);
  }
  if (found.places.empty()) found.add({.line = part.front().row}, 0);
  return found;
}

/// The token of each brace.
std::vector<std::size_t> bracesOf(Part part) {
  std::vector<std::size_t> braces;
  for (std::size_t i = 0; i < part.size(); ++i) {
    if (isMark(part[i], "{") || isMark(part[i], "}")) braces.push_back(i);
  }
  return braces;
}

/// Is the place behind "if (...)", "else" or "void f()", whose block begins below or ends in its line?
bool isBehindHead(Part part, std::size_t place, const LaidOut& partner) {
  if (!isMark(part[place], ")") && !isMark(part[place], "else") && !isMark(part[place], "do"))
    return false;
  const bool below = place + 1 == part.size() || part[place + 1].firstOfLine;
  return below || part[place].row == partner.row;
}

std::optional<MissingBrace> missingIn(Part part, NestingMark::Kind kind) {
  const bool close = kind == NestingMark::Kind::Close;
  const Candidates candidates = close ? placesToClose(part) : placesToOpen(part);
  const auto found = findMissingMarks(marksOf(part), candidates.places, kind);
  if (found.empty()) return std::nullopt;
  const LaidOut& partner = part[bracesOf(part)[found.front().partner]];
  const std::size_t place = candidates.after[found.front().place];
  return MissingBrace{close ? '}' : '{', *part[place].token, *partner.token, partner.statement,
                      !close && !isBehindHead(part, place, partner)};
}

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

std::optional<MissingBrace> findMissingBrace(const MappedText& text, const SourceLines& lines) {
  const std::vector<Token> tokens = tokensOf(text);
  const std::vector<LaidOut> layout = Layout(text, lines).read(tokens);
  for (const Part part : splitByFunction(layout)) {
    int balance = 0;
    for (const LaidOut& entry : part)
      balance += isMark(entry, "{") ? 1 : isMark(entry, "}") ? -1 : 0;
    if (balance == 0) continue;
    return missingIn(part, balance > 0 ? NestingMark::Kind::Close : NestingMark::Kind::Open);
  }
  return std::nullopt;
}

}  // namespace orris
