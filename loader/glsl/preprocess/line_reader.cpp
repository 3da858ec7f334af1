#include <orris/glsl/preprocess/line_reader.h>

#include <algorithm>
#include <cstring>
#include <iterator>

#include <orris/glsl/tokens/bounded_tokens.h>

namespace orris {
namespace {

bool hasByte(std::string_view text, char c) {
  return !text.empty() && std::memchr(text.data(), c, text.size()) != nullptr;
}

std::string_view withoutCarriageReturn(std::string_view text) {
  while (!text.empty() && (text.back() == '\r' || text.back() == '\n')) text.remove_suffix(1);
  return text;
}

bool startsWithByteOrderMark(std::string_view text) { return text.substr(0, 3) == "\xEF\xBB\xBF"; }

// Could the '#' line at `hash` be a conditional? All of them start with 'i' or 'e'.
bool maybeConditional(std::string_view text, std::size_t hash) {
  const std::size_t word = text.find_first_not_of(" \t", hash + 1);
  return word == std::string_view::npos || text[word] == 'i' || text[word] == 'e' ||
         text[word] == '/' || text[word] == '\\';
}

}  // namespace

// One untouched physical line needs no copy: `pieces_` gets one entry and the view is the author's.
std::string_view LineReader::readWhole() {
  pieces_.clear();
  const FlatLine& line = lines_[next_];
  const std::string_view text = withoutCarriageReturn(line.text);
  const bool simple = text.empty() || (text.back() != '\\' && !hasByte(text, '\0') &&
                                       !startsWithByteOrderMark(text));
  if (simple) {
    ++next_;
    pieces_.push_back({0, {line.site, line.line, 1}});
    count(text);
    return text;
  }
  joined_.clear();
  takePhysicalLine();
  return joined_;
}

// Lines of an inactive branch are skipped and do not count.
void LineReader::count(std::string_view text) {
  if (text.size() > bytesLeft_) next_ = lines_.size();
  bytesLeft_ -= std::min(text.size(), bytesLeft_);
}

// Appends a line and its `\` continuations to joined_.
void LineReader::takePhysicalLine() {
  bool more = true;
  while (more && !atEnd()) {
    const FlatLine& line = lines_[next_++];
    std::string_view text = withoutCarriageReturn(line.text);
    int column = 1;
    if (startsWithByteOrderMark(text)) {
      text.remove_prefix(3);
      column = 4;
    }
    more = !text.empty() && text.back() == '\\';
    if (more) text.remove_suffix(1);
    pieces_.push_back({joined_.size(), {line.site, line.line, column}});
    count(text);
    const std::size_t start = joined_.size();
    joined_ += text;
    joined_.erase(
        std::remove(joined_.begin() + static_cast<std::ptrdiff_t>(start), joined_.end(), '\0'),
        joined_.end());
  }
}

void LineReader::read(std::vector<Token>& tokens) {
  tokens.clear();
  const std::string_view text = readWhole();
  const std::size_t open = tokenizeAtMost(text, 0, left_, tokens);
  if (open < text.size()) {
    if (text.data() != joined_.data()) joined_ = text;
    closeComment(tokens, open);
  }
  place(tokens);
  left_ -= tokens.size();
  if (left_ > 0 && bytesLeft_ > 0) return;
  cutOff_ = tokens.empty() ? pieces_.front().origin : tokens.back().origin;
  next_ = lines_.size();
}

// Takes lines until the comment that starts at `open` ends, and the rest of the line it ends on.
void LineReader::closeComment(std::vector<Token>& tokens, std::size_t open) {
  while (open < joined_.size()) {
    std::size_t searchFrom = joined_.size();
    while (!atEnd()) {
      joined_ += '\n';
      takePhysicalLine();
      if (joined_.find("*/", searchFrom) != std::string::npos) break;
      searchFrom = joined_.size();
    }
    const std::size_t stillOpen = tokenizeAtMost(joined_, open, left_, tokens);
    if (stillOpen == open || (atEnd() && stillOpen < joined_.size())) {
      std::vector<Token> comment(1);
      comment[0].origin.column = static_cast<int>(stillOpen) + 1;
      place(comment);
      unclosed_ = comment[0].origin;
      return;
    }
    open = stillOpen;
  }
}

// Turns offsets into places.
void LineReader::place(std::vector<Token>& tokens) const {
  std::size_t piece = 0;
  for (Token& token : tokens) {
    const auto offset = static_cast<std::size_t>(token.origin.column) - 1;
    while (piece + 1 < pieces_.size() && pieces_[piece + 1].offset <= offset) ++piece;
    const Origin& start = pieces_[piece].origin;
    token.origin = {start.site, start.line,
                    start.column + static_cast<int>(offset - pieces_[piece].offset)};
  }
}

void LineReader::skipPlainLines() {
  for (; !atEnd(); ++next_) {
    const std::string_view text = withoutCarriageReturn(lines_[next_].text);
    if (text.empty()) continue;
    if (text.back() == '\\' || text.find("/*") != std::string_view::npos) return;
    const std::size_t first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos) continue;
    if (text[first] == '\0' || text[first] == '\xEF') return;
    if (text[first] == '#' && maybeConditional(text, first)) return;
  }
}

std::string_view LineReader::textOf(const Origin& origin) const {
  const auto matches = [&origin](const FlatLine& line) {
    return line.site == origin.site && line.line == origin.line;
  };
  const auto here = lines_.begin() + static_cast<std::ptrdiff_t>(std::min(next_, lines_.size()));
  const auto before = std::find_if(std::make_reverse_iterator(here), lines_.rend(), matches);
  if (before != lines_.rend()) return withoutCarriageReturn(before->text);
  const auto after = std::find_if(here, lines_.end(), matches);
  return after == lines_.end() ? std::string_view() : withoutCarriageReturn(after->text);
}

}  // namespace orris
