#include <fmt/core.h>
#include <orris/world/content/stated_json.h>

#include <algorithm>
#include <string>
#include <vector>

namespace orris {
namespace {

using Kind = JsonNode::Kind;

/// The numbers of a value; none where it is of another kind.
std::vector<float> componentsOf(const JsonNode& node, const StatedUniform& uniform) {
  if (uniform.type == StatedType::Bool)
    return node.kind == Kind::Boolean ? std::vector<float>{node.boolean ? 1.0f : 0.0f}
                                      : std::vector<float>{};
  std::vector<float> numbers;
  const auto add = [&](const JsonNode& number) {
    if (number.kind == Kind::Integer || number.kind == Kind::Real)
      numbers.push_back(float(number.real));
  };
  if (componentCount(uniform) == 1)
    add(node);
  else
    for (const JsonNode& item : node.items) add(item);
  return numbers;
}

std::string expectationOf(const StatedUniform& uniform) {
  if (uniform.type == StatedType::Bool) return "true or false";
  const bool whole = uniform.type == StatedType::Int || uniform.type == StatedType::IVec3;
  const std::string range = fmt::format("from {} to {}", uniform.low, uniform.high);
  if (componentCount(uniform) == 1)
    return fmt::format("a {} {}", whole ? "whole number" : "number", range);
  return fmt::format("a list of three {} {}", whole ? "whole numbers" : "numbers", range);
}

}  // namespace

StatedValues readStatedValues(JsonReader& reader, const JsonNode& environment) {
  StatedValues values;
  const JsonNode* node = environment.find("uniforms");
  if (!node) return values;
  std::vector<std::string> names;
  for (const StatedUniform& uniform : kStatedUniforms) names.emplace_back(uniform.name);
  if (!reader.object(*node, "\"uniforms\"", names)) return values;
  for (const JsonMember& member : node->members) {
    const StatedUniform* uniform = findStated(member.key);
    if (!uniform) continue;
    const std::vector<float> numbers = componentsOf(member.value, *uniform);
    if (!takes(*uniform, numbers)) {
      reader.expected(member.value, fmt::format("\"{}\"", member.key), expectationOf(*uniform));
      continue;
    }
    std::array<float, 3>& value = values[member.key];
    std::copy(numbers.begin(), numbers.end(), value.begin());
  }
  return values;
}

}  // namespace orris
