// Facts about the types of GLSL by name.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace orris {

/// A scalar, vector or matrix.
struct NumericType {
  char component = 'f';  ///< f, i, u, b or d
  int columns = 1;       ///< of a matrix, else 1
  int rows = 1;          ///< components of a vector or column, 1 for a scalar
};

/// component 0 when the name is no numeric type.
NumericType numericType(std::string_view name);
inline bool isNumeric(std::string_view name) { return numericType(name).component != 0; }

/// Both scalars, or both vectors: what Iris can convert between stages
/// (Iris: CompatibilityTransformer).
bool sameShape(std::string_view a, std::string_view b);

/// "sampler2DShadow" is {f, 2, shadow}, "uimage3D" {u, 3, image}.
struct OpaqueType {
  char component = 0;  ///< f, i or u; 0 when the name is neither a sampler nor an image
  int dimensions = 2;
  bool image = false;
  bool shadow = false;
  bool array = false;
};
OpaqueType opaqueType(std::string_view name);

/// Array sizes, outermost first; 0: unsized, -1: not known. Unknown ones may be equal.
bool sizesDiffer(const std::vector<std::int64_t>& a, const std::vector<std::int64_t>& b);
/// "vec3[4]"
std::string typeName(std::string_view type, const std::vector<std::int64_t>& sizes);

}  // namespace orris
