// Logical lines of a flattened source: `\`-newline joined, a comment over several lines kept whole.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <orris/core/limits.h>
#include <orris/glsl/tokens/token.h>

namespace orris {

class LineReader {
 public:
  explicit LineReader(const FlatSource& source) : lines_(source.lines) {}

  bool atEnd() const { return next_ >= lines_.size(); }

  /// Replaces `tokens` by those of the next logical line, comments included. Precondition: !atEnd().
  void read(std::vector<Token>& tokens);

  /// Advances over lines of an inactive branch, cheaply; stops before a line that may hold a
  /// conditional directive or that needs reading in full.
  void skipPlainLines();

  /// Place of the block comment that the source's end cut off; site -1 when there was none.
  const Origin& unclosedComment() const { return unclosed_; }

  /// Where the source has more tokens or bytes than a stage may have and was cut off; site -1: it has not.
  const Origin& cutOff() const { return cutOff_; }

  /// The author's text of the line at `origin`, nearest before the current one.
  std::string_view textOf(const Origin& origin) const;

 private:
  struct Piece {
    std::size_t offset;
    Origin origin;
  };

  void count(std::string_view text);
  void takePhysicalLine();
  std::string_view readWhole();
  void closeComment(std::vector<Token>& tokens, std::size_t open);
  void place(std::vector<Token>& tokens) const;

  const std::vector<FlatLine>& lines_;
  std::size_t next_ = 0;
  std::string joined_;  // text of the logical line when it is not one untouched physical line
  std::vector<Piece> pieces_;  // where its parts come from
  Origin unclosed_;
  Origin cutOff_;
  std::size_t left_ = limits::kStageTokens;
  std::size_t bytesLeft_ = limits::kStageReadBytes;
};

}  // namespace orris
