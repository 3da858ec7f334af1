#include <orris/world/files/json_reader.h>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include <orris/core/limits.h>

namespace orris {
namespace {

using Kind = JsonNode::Kind;

std::string describe(const JsonNode& node) {
  switch (node.kind) {
    case Kind::Null:
      return "null";
    case Kind::Boolean:
      return node.boolean ? "true" : "false";
    case Kind::Integer:
      return fmt::format("{}", node.integer);
    case Kind::Real:
      return fmt::format("{}", node.real);
    case Kind::String:
      return fmt::format("\"{}\"", node.text);
    case Kind::Array:
      return fmt::format("a list of {}", node.items.size());
    case Kind::Object:
      return "an object";
  }
  return "";
}

std::string member(const std::string& key) { return fmt::format("\"{}\"", key); }

}  // namespace

void JsonReader::error(std::size_t offset, std::string message, std::string hint) {
  failed_ = true;
  if (++errors_ > limits::kWorldErrors + 1) return;
  if (errors_ == limits::kWorldErrors + 1) message = "there are more errors from here on";
  Diagnostic diagnostic =
      source_.error(offset, source_.rules->valueId, std::move(message), std::move(hint));
  budget_.take(diagnostic);
  diagnostics_.push_back(std::move(diagnostic));
}

void JsonReader::expected(const JsonNode& node, const std::string& what,
                          const std::string& expectation) {
  error(node.offset, fmt::format("{} is {}: expected {}", what, describe(node), expectation));
}

bool JsonReader::object(const JsonNode& node, const std::string& what,
                        const std::vector<std::string>& keys) {
  if (node.kind != Kind::Object) {
    expected(node, what, "an object");
    return false;
  }
  bool clean = true;
  for (const JsonMember& entry : node.members) {
    if (std::find(keys.begin(), keys.end(), entry.key) != keys.end()) continue;
    clean = false;
    error(entry.offset, fmt::format("unknown key \"{}\" in {}: expected one of {}", entry.key, what,
                                    fmt::join(keys, ", ")));
  }
  return clean;
}

bool JsonReader::array(const JsonNode& node, const std::string& what) {
  if (node.kind == Kind::Array) return true;
  expected(node, what, "a list");
  return false;
}

const JsonNode* JsonReader::required(const JsonNode& parent, const std::string& key,
                                     const std::string& what) {
  const JsonNode* found = parent.find(key);
  if (!found) error(parent.offset, fmt::format("{} has no \"{}\"", what, key));
  return found;
}

std::optional<int> JsonReader::integer(const JsonNode& node, const std::string& what,
                                       IntegerRange range) {
  if (node.kind == Kind::Integer && node.integer >= range.low && node.integer <= range.high) {
    return int(node.integer);
  }
  expected(node, what, fmt::format("an integer from {} to {}", range.low, range.high));
  return std::nullopt;
}

std::optional<double> JsonReader::number(const JsonNode& node, const std::string& what,
                                         RealRange range) {
  const bool isNumber = node.kind == Kind::Integer || node.kind == Kind::Real;
  if (isNumber && node.real >= range.low && node.real <= range.high) return node.real;
  expected(node, what, fmt::format("a number from {} to {}", range.low, range.high));
  return std::nullopt;
}

std::optional<std::string> JsonReader::string(const JsonNode& node, const std::string& what) {
  if (node.kind == Kind::String) return node.text;
  expected(node, what, "a string");
  return std::nullopt;
}

std::optional<glm::ivec3> JsonReader::cell(const JsonNode& node, const std::string& what,
                                           IntegerRange range) {
  if (node.kind != Kind::Array || node.items.size() != 3) {
    expected(node, what, "three integers [x, y, z]");
    return std::nullopt;
  }
  glm::ivec3 value{0};
  for (int axis = 0; axis < 3; ++axis) {
    const std::optional<int> item = integer(node.items[std::size_t(axis)], what, range);
    if (!item) return std::nullopt;
    value[axis] = *item;
  }
  return value;
}

std::optional<glm::dvec3> JsonReader::vector(const JsonNode& node, const std::string& what,
                                             RealRange range) {
  if (node.kind != Kind::Array || node.items.size() != 3) {
    expected(node, what, "three numbers");
    return std::nullopt;
  }
  glm::dvec3 value{0};
  for (int axis = 0; axis < 3; ++axis) {
    const std::optional<double> item = number(node.items[std::size_t(axis)], what, range);
    if (!item) return std::nullopt;
    value[axis] = *item;
  }
  return value;
}

std::optional<BlockState> JsonReader::block(const JsonNode& node, const std::string& what) {
  const std::optional<std::string> text = string(node, what);
  if (!text) return std::nullopt;
  std::optional<BlockState> state = parseBlockState(*text);
  if (!state) {
    expected(node, what, "a block state such as \"oak_stairs[facing=north,half=bottom]\"");
  }
  return state;
}

void JsonReader::optional(const JsonNode& object, const std::string& key, bool& target) {
  const JsonNode* node = object.find(key);
  if (!node) return;
  if (node->kind == Kind::Boolean) {
    target = node->boolean;
  } else {
    expected(*node, member(key), "true or false");
  }
}

void JsonReader::optional(const JsonNode& object, const std::string& key, IntegerRange range,
                          int& target) {
  const JsonNode* node = object.find(key);
  if (node) target = integer(*node, member(key), range).value_or(target);
}

void JsonReader::optional(const JsonNode& object, const std::string& key, RealRange range,
                          float& target) {
  double value = target;
  optional(object, key, range, value);
  target = float(value);
}

void JsonReader::optional(const JsonNode& object, const std::string& key, RealRange range,
                          double& target) {
  const JsonNode* node = object.find(key);
  if (node) target = number(*node, member(key), range).value_or(target);
}

void JsonReader::optional(const JsonNode& object, const std::string& key, RealRange range,
                          glm::vec3& target) {
  const JsonNode* node = object.find(key);
  if (!node) return;
  if (const auto value = vector(*node, member(key), range)) target = glm::vec3(*value);
}

void JsonReader::optional(const JsonNode& object, const std::string& key, std::string& target) {
  const JsonNode* node = object.find(key);
  if (node) target = string(*node, member(key)).value_or(target);
}

}  // namespace orris
