#include <orris/glsl/tokens/token.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>

#include <orris/glsl/tokens/bounded_tokens.h>

namespace orris {
namespace {

// Longest first, so that the first match is the right one.
constexpr std::array<std::string_view, 24> kLongPunctuators = {
    "<<=", ">>=", "...", "++", "--", "+=", "-=", "*=", "/=", "%=", "&=", "|=",
    "^=",  "<<",  ">>",  "<=", ">=", "==", "!=", "&&", "||", "^^", "##", "//"};

enum CharClass : unsigned char { kOther, kSpace, kLetter, kDigit, kPunctuator };

constexpr std::array<CharClass, 256> makeClasses() {
  std::array<CharClass, 256> classes{};
  for (unsigned char c : std::string_view(" \t\r\n\f\v")) classes[c] = kSpace;
  for (int c = 'a'; c <= 'z'; ++c) classes[static_cast<std::size_t>(c)] = kLetter;
  for (int c = 'A'; c <= 'Z'; ++c) classes[static_cast<std::size_t>(c)] = kLetter;
  classes['_'] = kLetter;
  for (int c = '0'; c <= '9'; ++c) classes[static_cast<std::size_t>(c)] = kDigit;
  for (unsigned char c : std::string_view("+-*/%<>=!&|^~?:;,.()[]{}#")) classes[c] = kPunctuator;
  return classes;
}

constexpr std::array<CharClass, 256> kClasses = makeClasses();

CharClass classOf(char c) { return kClasses[static_cast<unsigned char>(c)]; }
bool isWord(char c) { return classOf(c) == kLetter || classOf(c) == kDigit; }

std::size_t endOfWord(std::string_view text, std::size_t i) {
  while (i < text.size() && isWord(text[i])) ++i;
  return i;
}

// A preprocessing number; a sign belongs to it only after a decimal exponent ("1e-3", not "0xE-3").
std::size_t endOfNumber(std::string_view text, std::size_t i) {
  const bool hex = text[i] == '0' && i + 1 < text.size() && (text[i + 1] | 0x20) == 'x';
  while (i < text.size()) {
    const char c = text[i];
    if (!hex && (c | 0x20) == 'e' && i + 1 < text.size() &&
        (text[i + 1] == '+' || text[i + 1] == '-')) {
      i += 2;
    } else if (isWord(c) || c == '.') {
      ++i;
    } else {
      break;
    }
  }
  return i;
}

std::size_t endOfPunctuator(std::string_view text, std::size_t i) {
  if (i + 1 >= text.size() || classOf(text[i + 1]) != kPunctuator) return i + 1;
  for (std::string_view p : kLongPunctuators) {
    if (text.compare(i, p.size(), p) == 0) return i + p.size();
  }
  return i + 1;
}

// Bytes outside ASCII stay together, so that a character is never cut.
std::size_t endOfOther(std::string_view text, std::size_t i) {
  if (static_cast<unsigned char>(text[i]) < 0x80) return i + 1;
  while (i < text.size() && static_cast<unsigned char>(text[i]) >= 0x80) ++i;
  return i;
}

bool startsNumber(std::string_view text, std::size_t i) {
  return classOf(text[i]) == kDigit ||
         (text[i] == '.' && i + 1 < text.size() && classOf(text[i + 1]) == kDigit);
}

struct Span {
  TokenKind kind;
  std::size_t end;
};

// The token that starts at i, which is not white space; an unclosed comment has end npos.
Span scanToken(std::string_view text, std::size_t i) {
  const CharClass c = classOf(text[i]);
  if (c == kLetter) return {TokenKind::Identifier, endOfWord(text, i)};
  if (startsNumber(text, i)) return {TokenKind::Number, endOfNumber(text, i)};
  if (text.compare(i, 2, "//") == 0) {
    return {TokenKind::Comment, std::min(text.find('\n', i), text.size())};
  }
  if (text.compare(i, 2, "/*") == 0) {
    const std::size_t close = text.find("*/", i + 2);
    return {TokenKind::Comment, close == std::string_view::npos ? close : close + 2};
  }
  if (c == kPunctuator) return {TokenKind::Punctuator, endOfPunctuator(text, i)};
  return {TokenKind::Other, endOfOther(text, i)};
}

}  // namespace

std::size_t tokenizeFrom(std::string_view text, std::size_t from, std::vector<Token>& out) {
  return tokenizeAtMost(text, from, std::string_view::npos, out);
}

std::size_t tokenizeAtMost(std::string_view text, std::size_t from, std::size_t most,
                           std::vector<Token>& out) {
  bool space = false;
  int newlines = 0;
  std::size_t i = from;
  while (i < text.size()) {
    if (classOf(text[i]) == kSpace) {
      newlines += text[i] == '\n';
      space = true;
      ++i;
      continue;
    }
    const Span span = scanToken(text, i);
    if (span.end == std::string_view::npos) return i;
    if (out.size() >= most) break;
    Token& token = out.emplace_back();
    token.kind = span.kind;
    token.text.assign(text, i, span.end - i);
    token.spaceBefore = space;
    token.newlinesBefore = newlines;
    token.origin.column = static_cast<int>(i) + 1;
    space = false;
    newlines = 0;
    i = span.end;
  }
  return text.size();
}

std::vector<Token> tokenize(std::string_view text) {
  std::vector<Token> tokens;
  const std::size_t open = tokenizeFrom(text, 0, tokens);
  if (open < text.size()) {
    Token& comment = tokens.emplace_back();
    comment.kind = TokenKind::Comment;
    comment.text = std::string(text.substr(open));
    comment.origin.column = static_cast<int>(open) + 1;
  }
  int line = 1;
  std::size_t lineStart = 0;
  std::size_t scanned = 0;
  for (Token& token : tokens) {
    const auto offset = static_cast<std::size_t>(token.origin.column) - 1;
    for (; scanned < offset; ++scanned) {
      if (text[scanned] != '\n') continue;
      ++line;
      lineStart = scanned + 1;
    }
    token.origin.line = line;
    token.origin.column = static_cast<int>(offset - lineStart) + 1;
  }
  return tokens;
}

bool wouldGlue(const Token& left, const Token& right) {
  if (left.text.empty() || right.text.empty()) return false;
  const char l = left.text.back();
  const char r = right.text.front();
  if (isWord(l) && isWord(r)) return true;
  if (left.kind == TokenKind::Number)
    return r == '.' || ((l | 0x20) == 'e' && (r == '+' || r == '-'));
  if (l == '.' && classOf(r) == kDigit) return true;
  if (left.kind != TokenKind::Punctuator || right.kind != TokenKind::Punctuator) return false;
  const std::string pair = left.text + right.text;
  return endOfPunctuator(pair, 0) != left.text.size() || (l == '/' && r == '*');
}

namespace {

class Printer {
 public:
  explicit Printer(const TokenStream& stream) : stream_(stream) {
    out_.sites = stream.sites;
    out_.macroNames = stream.macroNames;
    out_.macroOrigins = stream.macroOrigins;
    out_.lines.emplace_back();
  }

  MappedText run() {
    printHeader();
    for (const Token& token : stream_.tokens) printToken(token);
    if (column_ > 1) newline();
    out_.lines.pop_back();
    blankUnused();
    return std::move(out_);
  }

 private:
  void printHeader() {
    if (stream_.version > 0) {
      const char* gap = stream_.profile.empty() ? "" : " ";
      printLine(fmt::format("#version {}{}{}", stream_.version, gap, stream_.profile),
                stream_.versionOrigin);
    }
    for (const TokenStream::Extension& e : stream_.extensions) {
      printLine(fmt::format("#extension {} : {}", e.name, e.behaviour), e.origin);
    }
  }

  void printLine(const std::string& text, const Origin& origin) {
    out_.lines.back().push_back({1, origin, -1, {}});
    out_.text += text;
    newline();
  }

  void printToken(const Token& token) {
    newlines_ = std::max(newlines_, token.newlinesBefore);
    space_ = space_ || token.spaceBefore;
    if (token.kind == TokenKind::Comment) {
      space_ = true;
      return;
    }
    if (newlines_ > 0) {
      if (column_ > 1) newline();
      if (newlines_ > 1 && previous_) newline();
      // The author's indentation; deep macro bodies and host tokens start at the margin.
      indent(token);
    } else if (column_ > 1 && (space_ || (previous_ && mustNotGlue(*previous_, token)))) {
      append(" ");
    }
    out_.lines.back().push_back({column_, token.origin, token.macro, token.written});
    if (token.unused) markUnused(token.text.size());
    append(token.text);
    previous_ = &token;
    newlines_ = 0;
    space_ = false;
  }

  void markUnused(std::size_t length) {
    const bool goesOn = previous_ && previous_->unused && !unused_.empty();
    if (!goesOn) unused_.push_back({out_.text.size(), 0});
    unused_.back().end = out_.text.size() + length;
  }

  // Columns and lines stay, so that the map is right for both.
  void blankUnused() {
    for (const auto& [begin, end] : unused_) {
      out_.unused.push_back({begin, out_.text.substr(begin, end - begin)});
      std::replace_if(
          out_.text.begin() + static_cast<std::ptrdiff_t>(begin),
          out_.text.begin() + static_cast<std::ptrdiff_t>(end), [](char c) { return c != '\n'; },
          ' ');
    }
  }

  // Tokens of the pack run together as Iris prints them: with N defined as 16, "N.0" is 16.0.
  // (Iris: JcppProcessor appends the text of each token.)
  static bool mustNotGlue(const Token& left, const Token& right) {
    return (left.origin.site < 0 || right.origin.site < 0) && wouldGlue(left, right);
  }

  void indent(const Token& token) {
    constexpr int kMaxIndent = 40;
    if (token.origin.site < 0 || token.macro >= 0) return;
    append(std::string(static_cast<std::size_t>(std::clamp(token.origin.column - 1, 0, kMaxIndent)),
                       ' '));
  }

  void append(const std::string& text) {
    out_.text += text;
    column_ += static_cast<int>(text.size());
  }

  void newline() {
    out_.text += '\n';
    out_.lines.emplace_back();
    column_ = 1;
  }

  struct Range {
    std::size_t begin, end;
  };

  const TokenStream& stream_;
  MappedText out_;
  std::vector<Range> unused_;  ///< in the text
  const Token* previous_ = nullptr;
  int column_ = 1;
  int newlines_ = 0;
  bool space_ = false;
};

}  // namespace

MappedText print(const TokenStream& stream) { return Printer(stream).run(); }

}  // namespace orris
