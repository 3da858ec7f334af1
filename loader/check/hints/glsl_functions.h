// Names of functions: those of GLSL, and those that a text defines.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <orris/glsl/compile/validate.h>

namespace orris {

/// The functions of GLSL 4.50 and the old ones that the host still takes (texture2D), sorted.
const std::vector<std::string>& builtInFunctions();

/// The functions that the text defines, and where first.
std::map<std::string, SourceLocation> definedFunctions(const MappedText& text);

}  // namespace orris
