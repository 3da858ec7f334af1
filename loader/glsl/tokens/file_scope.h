// Fast reading of file scope in a final text: only statements with a given word become tokens.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace orris {

/// An input or output variable of a stage.
struct StageVarying {
  std::string name, type;
  std::string qualifiers;  ///< all but in and out, "flat "
  bool input = false, array = false, layout = false;
};

struct FileScope {
  std::vector<StageVarying> varyings;     ///< no blocks
  std::size_t first = std::string::npos;  ///< offset of the first declaration or function
  std::size_t mainBegin = std::string::npos, mainEnd = std::string::npos;  ///< inside the braces
};

/// Reads a text that the host printed: no comments, directives on lines of their own.
FileScope readFileScope(std::string_view text);

}  // namespace orris
