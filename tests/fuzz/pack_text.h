// A pack as one text, which a fuzzer can change: a line "=== /path" starts each file.
#pragma once

#include <map>
#include <sstream>
#include <string>

namespace orris {

/// What stands before the first such line is /composite.fsh.
inline std::map<std::string, std::string> filesOfText(const std::string& text) {
  std::istringstream stream(text);
  std::map<std::string, std::string> files;
  std::string* file = &files["/composite.fsh"];
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with("=== ")) {
      file = &files[line.substr(4)];
    } else {
      *file += line + "\n";
    }
  }
  return files;
}

}  // namespace orris
