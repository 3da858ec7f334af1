// Tokens of a final text as views, in one pass and without allocation.
#pragma once

#include <cstddef>
#include <string_view>

namespace orris {

struct TextToken {
  enum class Kind { End, Word, Number, Punctuator };
  Kind kind = Kind::End;
  std::string_view text;
  int line = 0;
  int column = 0;  ///< from 1

  bool is(char punctuator) const {
    return kind == Kind::Punctuator && text.size() == 1 && text[0] == punctuator;
  }
  bool isWord() const { return kind == Kind::Word; }
};

/// Reads GLSL that the host printed: no comments; lines that start with '#' are skipped.
class TextScanner {
 public:
  explicit TextScanner(std::string_view text) : text_(text) {}
  TextToken next();

 private:
  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t lineStart_ = 0;
  int line_ = 1;
};

}  // namespace orris
