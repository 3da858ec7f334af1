// Lines of a source without their comments.
#pragma once

#include <string>
#include <string_view>

namespace orris {

/// The text of a line without comments; block comments go on in `inComment`, false before a file's first.
std::string codeOfLine(std::string_view line, bool& inComment);

}  // namespace orris
