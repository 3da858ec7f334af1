#include <orris/check/interface/glsl_types.h>

#include <fmt/format.h>

#include <array>

namespace orris {
namespace {

bool isSize(char c) { return c >= '2' && c <= '4'; }

bool takePrefix(std::string_view& text, std::string_view prefix) {
  if (!text.starts_with(prefix)) return false;
  text.remove_prefix(prefix.size());
  return true;
}

NumericType scalarType(std::string_view name) {
  constexpr std::array<std::string_view, 5> kScalars = {"float", "int", "uint", "bool", "double"};
  for (const std::string_view scalar : kScalars) {
    if (name == scalar) return {scalar.front(), 1, 1};
  }
  return {0, 0, 0};
}

NumericType matrixType(std::string_view name, char component) {
  const bool square = name.size() == 1 && isSize(name[0]);
  const bool full = name.size() == 3 && isSize(name[0]) && name[1] == 'x' && isSize(name[2]);
  if (!square && !full) return {0, 0, 0};
  return {component, name.front() - '0', name.back() - '0'};
}

}  // namespace

NumericType numericType(std::string_view name) {
  const NumericType scalar = scalarType(name);
  if (scalar.component != 0) return scalar;
  char component = 'f';
  std::string_view rest = name;
  for (const char prefix : {'i', 'u', 'b', 'd'}) {
    if (rest.starts_with(prefix)) {
      component = prefix;
      rest.remove_prefix(1);
      break;
    }
  }
  if (takePrefix(rest, "mat")) return matrixType(rest, component);
  if (takePrefix(rest, "vec") && rest.size() == 1 && isSize(rest[0])) {
    return {component, 1, rest[0] - '0'};
  }
  return {0, 0, 0};
}

bool sameShape(std::string_view a, std::string_view b) {
  const NumericType first = numericType(a), second = numericType(b);
  if (first.component == 0 || second.component == 0) return false;
  return (first.columns == 1) == (second.columns == 1) && (first.rows == 1) == (second.rows == 1);
}

OpaqueType opaqueType(std::string_view name) {
  OpaqueType type{.component = 'f'};
  if (takePrefix(name, "i")) {
    // "image2D" starts with the letter of isampler2D.
    if (name.starts_with("mage")) {
      type.image = true;
      name.remove_prefix(4);
    } else {
      type.component = 'i';
    }
  } else if (takePrefix(name, "u")) {
    type.component = 'u';
  }
  if (!type.image) {
    type.image = takePrefix(name, "image");
    if (!type.image && !takePrefix(name, "sampler")) return {};
  }
  if (name.empty()) return {};
  if (name.starts_with("Cube")) {
    type.dimensions = 3;
  } else if (name[0] >= '1' && name[0] <= '3') {
    type.dimensions = name[0] - '0';
  } else if (!name.starts_with("Buffer")) {
    return {};
  }
  type.array = name.find("Array") != std::string_view::npos;
  type.shadow = name.ends_with("Shadow");
  return type;
}

bool sizesDiffer(const std::vector<std::int64_t>& a, const std::vector<std::int64_t>& b) {
  if (a.size() != b.size()) return true;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i] > 0 && b[i] > 0 && a[i] != b[i]) return true;
  }
  return false;
}

std::string typeName(std::string_view type, const std::vector<std::int64_t>& sizes) {
  std::string name(type);
  for (const std::int64_t size : sizes) name += size > 0 ? fmt::format("[{}]", size) : "[]";
  return name;
}

}  // namespace orris
