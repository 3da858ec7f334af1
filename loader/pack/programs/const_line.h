// "const TYPE NAME = VALUE;" lines of a preprocessed stage. Contract: constants.csv "(grammar)".
#pragma once

#include <string>
#include <vector>

#include <orris/glsl/tokens/token.h>

namespace orris {

/// One declaration, as text.
struct ConstLine {
  std::string type, name, value;
  Origin origin;  ///< of the word const, or of the line inside a block comment
  std::string sourceLine;
};

/// All lines that start with const and declare int, float, bool, vec2, ivec3 or vec4, in code and
/// inside block comments, in order.
std::vector<ConstLine> findConstLines(const TokenStream& stream);

}  // namespace orris
