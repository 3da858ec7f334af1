#include <orris/glsl/syntax/brace_check.h>

#include <algorithm>
#include <map>
#include <span>
#include <string>
#include <vector>

#include <orris/glsl/syntax/brace_layout.h>
#include <orris/glsl/syntax/nesting.h>
#include <orris/glsl/tokens/text_tokens.h>

namespace orris {
namespace {

bool isFlowWord(const std::string& word) {
  return word == "if" || word == "for" || word == "while" || word == "switch" || word == "else" ||
         word == "return";
}

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

/// A '}' that ends a function where its layout goes on, or that stands behind the one that ends it.
/// nullopt: the layout does not say so, and a '{' may be missing.
std::optional<MissingBrace> surplusIn(Part part) {
  if (!startsFunction(part, 0)) return std::nullopt;
  const LaidOut* open = nullptr;
  int depth = 0;
  for (std::size_t i = 0; i + 1 < part.size(); ++i) {
    if (isMark(part[i], "{") && depth++ == 0) open = &part[i];
    if (!isMark(part[i], "}") || --depth > 0) continue;
    const LaidOut &end = part[i], &next = part[i + 1];
    const bool ends = open && end.firstOfLine && end.file == open->file &&
                      end.indent == open->statement;
    if (!ends || !next.firstOfLine || next.file != end.file) return std::nullopt;
    const bool twice = isMark(next, "}") && next.indent == end.indent;
    if (!twice && next.indent <= end.indent) return std::nullopt;
    const Token& surplus = *(twice ? next : end).token;
    return MissingBrace{'{', surplus, surplus, end.indent, true};
  }
  return std::nullopt;
}

}  // namespace

std::optional<MissingBrace> findMissingBrace(const MappedText& text, const SourceLines& lines) {
  const std::vector<Token> tokens = tokensOf(text);
  const std::vector<LaidOut> layout = readLayout(tokens, text, lines);
  for (const Part part : splitByFunction(layout)) {
    int balance = 0;
    for (const LaidOut& entry : part)
      balance += isMark(entry, "{") ? 1 : isMark(entry, "}") ? -1 : 0;
    if (balance == 0) continue;
    if (balance > 0) return missingIn(part, NestingMark::Kind::Close);
    const auto surplus = surplusIn(part);
    return surplus ? surplus : missingIn(part, NestingMark::Kind::Open);
  }
  return std::nullopt;
}

}  // namespace orris
