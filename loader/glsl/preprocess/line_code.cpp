#include <orris/glsl/preprocess/line_code.h>

namespace orris {

std::string codeOfLine(std::string_view line, bool& inComment) {
  std::string code;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const std::string_view two = line.substr(i, 2);
    if (inComment) {
      if (two == "*/") inComment = false, ++i;
    } else if (two == "/*") {
      inComment = true;
      ++i;
    } else if (two == "//") {
      break;
    } else {
      code += line[i];
    }
  }
  return code;
}

}  // namespace orris
