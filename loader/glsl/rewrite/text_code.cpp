#include <orris/glsl/rewrite/text_code.h>

#include <algorithm>

namespace orris {
namespace {

/// Of directives, the "#" begins a line.
bool startsDirective(const std::string& text, std::size_t offset) {
  return text[offset] == '#' && (offset == 0 || text[offset - 1] == '\n');
}

}  // namespace

std::vector<Token> codeTokens(const std::string& text) {
  std::vector<Token> all, code;
  tokenizeFrom(text, 0, all);
  std::size_t skipTo = 0;
  for (Token& token : all) {
    const std::size_t offset = offsetOf(token);
    if (startsDirective(text, offset)) skipTo = std::min(text.find('\n', offset), text.size());
    if (offset >= skipTo) code.push_back(std::move(token));
  }
  return code;
}

}  // namespace orris
