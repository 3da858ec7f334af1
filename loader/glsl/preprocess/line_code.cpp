#include <orris/glsl/preprocess/line_code.h>

#include <algorithm>

namespace orris {

std::string codeOfLine(std::string_view line, bool& inComment) {
  constexpr std::size_t kMark = 2;  // characters of each of the three
  std::string code;
  while (!line.empty()) {
    const std::size_t mark = inComment ? line.find("*/") : std::min(line.find("/*"), line.find("//"));
    if (!inComment) code += line.substr(0, mark);
    if (mark == std::string_view::npos || line.substr(mark, kMark) == "//") break;
    inComment = !inComment;
    line.remove_prefix(mark + kMark);
  }
  return code;
}

}  // namespace orris
