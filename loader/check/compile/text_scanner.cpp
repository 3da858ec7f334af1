#include <orris/check/compile/text_scanner.h>

#include <array>

namespace orris {
namespace {

enum CharClass : unsigned char { kOther, kWord, kDigit };

constexpr std::array<CharClass, 256> makeClasses() {
  std::array<CharClass, 256> classes{};
  for (int c = 'a'; c <= 'z'; ++c) classes[static_cast<std::size_t>(c)] = kWord;
  for (int c = 'A'; c <= 'Z'; ++c) classes[static_cast<std::size_t>(c)] = kWord;
  for (int c = '0'; c <= '9'; ++c) classes[static_cast<std::size_t>(c)] = kDigit;
  classes['_'] = kWord;
  return classes;
}
constexpr std::array<CharClass, 256> kClasses = makeClasses();

CharClass classOf(char c) { return kClasses[static_cast<unsigned char>(c)]; }

}  // namespace

TextToken TextScanner::next() {
  for (; at_ < text_.size(); ++at_) {
    const char c = text_[at_];
    if (c == '\n') {
      ++line_;
      lineStart_ = at_ + 1;
    } else if (c == '#') {
      while (at_ + 1 < text_.size() && text_[at_ + 1] != '\n') ++at_;
    } else if (static_cast<unsigned char>(c) > ' ') {
      break;
    }
  }
  TextToken token;
  token.line = line_;
  token.column = static_cast<int>(at_ - lineStart_) + 1;
  if (at_ >= text_.size()) return token;
  const std::size_t begin = at_++;
  const CharClass first = classOf(text_[begin]);
  token.kind = first == kWord    ? TextToken::Kind::Word
               : first == kDigit ? TextToken::Kind::Number
                                 : TextToken::Kind::Punctuator;
  if (first != kOther)
    while (at_ < text_.size() && classOf(text_[at_]) != kOther) ++at_;
  token.text = text_.substr(begin, at_ - begin);
  return token;
}

}  // namespace orris
