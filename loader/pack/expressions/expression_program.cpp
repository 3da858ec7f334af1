#include <orris/pack/expressions/expression_program.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <orris/pack/files/text.h>

namespace orris {
namespace {

using Kind = ExpressionNode::Kind;

/// Columns of a matrix, components of a vector; 0 for a scalar.
int matrixSide(ValueType type) {
  return type == ValueType::Mat3 ? 3 : type == ValueType::Mat4 ? 4 : 0;
}

bool isWholeVector(ValueType type) { return type == ValueType::IVec2 || type == ValueType::IVec3; }

/// 0 to 3 for x y z w, r g b a, s t p q or a digit; -1 otherwise.
int elementIndex(std::string_view access) {
  if (access.size() != 1) return -1;
  for (const std::string_view letters : {"xyzw", "rgba", "stpq", "0123"}) {
    const size_t at = letters.find(access[0]);
    if (at != std::string_view::npos) return static_cast<int>(at);
  }
  return -1;
}

class Compiler {
 public:
  Compiler(const VariableLookup& lookup, int& smoothStates, ExpressionFindings& findings)
      : lookup_(lookup), smoothStates_(smoothStates), findings_(findings) {}

  std::optional<ExpressionNode> compile(const ExpressionTree& tree) {
    switch (tree.kind) {
      case ExpressionTree::Kind::Literal:
        return ExpressionNode{
            .kind = Kind::Constant, .type = tree.literal.type, .constant = tree.literal};
      case ExpressionTree::Kind::Name:
        return compileName(tree);
      default:
        return compileCall(tree);
    }
  }

  std::optional<ExpressionNode> convert(ExpressionNode node, ValueType type, int column) {
    if (node.type == type) return node;
    const bool widen = node.type == ValueType::Int && type == ValueType::Float;
    const bool narrow = node.isWhole && type == ValueType::Int;
    if (!widen && !narrow) {
      const bool cut = node.type == ValueType::Float && type == ValueType::Int;
      return fail(column,
                  fmt::format("expected {}, found {}{}", typeName(type), typeName(node.type),
                              cut ? "; write toInt(), floor() or ceil() around it" : ""));
    }
    ExpressionNode converted{.kind = widen ? Kind::ToFloat : Kind::ToInt, .type = type};
    converted.children.push_back(std::move(node));
    return converted;
  }

 private:
  std::nullopt_t fail(int column, std::string message) {
    findings_.error = {std::move(message), column};
    return std::nullopt;
  }

  std::optional<ExpressionNode> compileName(const ExpressionTree& tree) {
    const auto variable = lookup_(tree.name);
    if (!variable) return fail(tree.column, fmt::format("unknown name {}", tree.name));
    ExpressionNode node{.kind = variable->custom < 0 ? Kind::Input : Kind::Custom,
                        .type = variable->type,
                        .input = tree.name,
                        .index = variable->custom};
    return tree.accesses.empty() ? std::optional(std::move(node))
                                 : compileAccess(tree, std::move(node));
  }

  std::optional<ExpressionNode> compileAccess(const ExpressionTree& tree, ExpressionNode variable) {
    const int side = matrixSide(variable.type);
    const int count = side > 0 ? side : componentCount(variable.type);
    const size_t wanted = side > 0 ? 2 : 1;
    int index = 0;
    for (const std::string& access : tree.accesses) {
      const int element = elementIndex(access);
      if (count == 1 || element < 0 || element >= count || tree.accesses.size() != wanted) {
        return fail(tree.column,
                    fmt::format("{} is {}; it has no element .{}", tree.name,
                                typeName(variable.type), fmt::join(tree.accesses, ".")));
      }
      // Iris takes the first index as column, and packs are written for that.
      index = index * side + element;
    }
    ExpressionNode node{.kind = Kind::Element,
                        .type = isWholeVector(variable.type) ? ValueType::Int : ValueType::Float,
                        .index = index};
    node.children.push_back(std::move(variable));
    return node;
  }

  std::optional<ExpressionNode> compileCall(const ExpressionTree& tree) {
    if (!isExpressionFunction(tree.name))
      return fail(tree.column, fmt::format("unknown function {}", tree.name));
    std::vector<ExpressionNode> arguments;
    for (const ExpressionTree& argument : tree.arguments) {
      auto compiled = compile(argument);
      if (!compiled) return std::nullopt;
      arguments.push_back(std::move(*compiled));
    }
    if (tree.name == "if") return compileIf(tree, std::move(arguments));
    if (tree.name == "smooth") return compileSmooth(tree, std::move(arguments));
    if (isAmbiguous(tree.name) && std::ranges::all_of(arguments, &ExpressionNode::isEither)) {
      return fail(tree.column, fmt::format("Iris cannot decide whether {} compares ints or floats; "
                                           "write toInt() around one side",
                                           tree.name));
    }
    if (isCutShort(tree.name, arguments.size())) warnOfCutShort(tree);
    return compileOverload(tree, std::move(arguments));
  }

  std::optional<ExpressionNode> compileOverload(const ExpressionTree& tree,
                                                std::vector<ExpressionNode> arguments) {
    std::vector<ValueType> types, asInts;
    for (const ExpressionNode& argument : arguments) {
      types.push_back(argument.type);
      asInts.push_back(argument.isWhole ? ValueType::Int : argument.type);
    }
    ExpressionOverload overload = findOverload(tree.name, types);
    if (!overload.function) overload = findOverload(tree.name, asInts);
    if (!overload.function) return fail(tree.column, mismatch(tree.name, types));
    ExpressionNode node{.kind = Kind::Call, .type = overload.result, .function = overload.function};
    if (overload.result == ValueType::Float) markWhole(tree, arguments, node);
    return adopt(std::move(node), std::move(arguments), overload.parameters, tree);
  }

  static bool isWhole(const ExpressionNode& node) {
    return node.type == ValueType::Int || node.isWhole;
  }

  static void markWhole(const ExpressionTree& tree, const std::vector<ExpressionNode>& arguments,
                        ExpressionNode& node) {
    const bool rounds = tree.name == "floor" || tree.name == "ceil";
    const bool carries = mayBeInt(tree.name);
    node.isWhole = rounds || (carries && std::ranges::all_of(arguments, isWhole));
    node.isEither =
        rounds || (carries && std::ranges::all_of(arguments, &ExpressionNode::isEither));
  }

  void warnOfCutShort(const ExpressionTree& tree) {
    findings_.slips.push_back(
        {fmt::format("Iris looks at the first two of these {} arguments of {} only",
                     tree.arguments.size(), tree.name),
         tree.column});
  }

  static std::string mismatch(const std::string& name, const std::vector<ValueType>& types) {
    std::vector<std::string_view> names;
    for (const ValueType type : types) names.push_back(typeName(type));
    return fmt::format("{} does not take ({})", name == "neg" ? "-" : name, fmt::join(names, ", "));
  }

  std::optional<ExpressionNode> adopt(ExpressionNode node, std::vector<ExpressionNode> children,
                                      const std::vector<ValueType>& types,
                                      const ExpressionTree& tree) {
    for (size_t i = 0; i < children.size(); ++i) {
      auto child = convert(std::move(children[i]), types[i], tree.arguments[i].column);
      if (!child) return std::nullopt;
      node.children.push_back(std::move(*child));
    }
    return node;
  }

  /// if(condition, value, [condition, value,]... otherwise)
  std::optional<ExpressionNode> compileIf(const ExpressionTree& tree,
                                          std::vector<ExpressionNode> arguments) {
    const size_t count = arguments.size();
    if (count < 3 || count > 33 || count % 2 == 0) {
      return fail(tree.column, fmt::format("if takes 3, 5, ... 33 arguments, not {}", count));
    }
    ValueType type = arguments.back().type;
    for (size_t i = 1; i < count; i += 2) {
      if (type == ValueType::Int) type = arguments[i].type;
    }
    std::vector<ValueType> types(count, type);
    ExpressionNode node{.kind = Kind::If, .type = type};
    node.isWhole = node.isEither = type == ValueType::Float;
    for (size_t i = 0; i < count; ++i) {
      const bool isCondition = i % 2 == 0 && i + 1 < count;
      if (isCondition) types[i] = ValueType::Bool;
      node.isWhole = node.isWhole && (isCondition || isWhole(arguments[i]));
      node.isEither = node.isEither && (isCondition || arguments[i].isEither);
    }
    return adopt(std::move(node), std::move(arguments), types, tree);
  }

  /// smooth([id,] value [, up [, down]]); the node's children are value, up and down.
  std::optional<ExpressionNode> compileSmooth(const ExpressionTree& tree,
                                              std::vector<ExpressionNode> arguments) {
    const size_t count = arguments.size();
    if (count < 1 || count > 4)
      return fail(tree.column, fmt::format("smooth takes 1 to 4 arguments, not {}", count));
    const bool hasId = count == 4 || (count > 1 && arguments.front().kind == Kind::Constant);
    const size_t first = hasId ? 1 : 0;
    ExpressionNode node{.kind = Kind::Smooth, .type = ValueType::Float, .index = smoothStates_++};
    for (size_t i = first; i < count; ++i) {
      auto child = convert(std::move(arguments[i]), ValueType::Float, tree.arguments[i].column);
      if (!child) return std::nullopt;
      node.children.push_back(std::move(*child));
    }
    return node;
  }

  const VariableLookup& lookup_;
  int& smoothStates_;
  ExpressionFindings& findings_;
};

float evaluateSmooth(const ExpressionNode& node, EvaluationState& state) {
  const auto child = [&](size_t i) { return evaluateExpression(node.children[i], state).f[0]; };
  const float target = child(0);
  const float up = node.children.size() > 1 ? child(1) : 1;
  const float down = node.children.size() > 2 ? child(2) : up;
  SmoothState& smooth = state.smooth[static_cast<size_t>(node.index)];
  if (!smooth.started) {
    smooth = {true, target};
    return target;
  }
  // Iris: SmoothFloat; half-lives are in tenths of a second.
  const float halfLife = (target > smooth.value ? up : down) * 0.1f;
  const float decay =
      halfLife > 0 ? std::exp(-std::numbers::ln2_v<float> * state.context.frameTime / halfLife) : 0;
  smooth.value += (target - smooth.value) * (1 - decay);
  return smooth.value;
}

Value evaluateIf(const ExpressionNode& node, EvaluationState& state) {
  for (size_t i = 0; i + 1 < node.children.size(); i += 2) {
    if (evaluateExpression(node.children[i], state).i[0] != 0) {
      return evaluateExpression(node.children[i + 1], state);
    }
  }
  return evaluateExpression(node.children.back(), state);
}

Value elementOf(const Value& value, int index) {
  const size_t at = static_cast<size_t>(index);
  return isWholeVector(value.type) ? Value::ofInt(value.i[at]) : Value::ofFloat(value.f[at]);
}

}  // namespace

std::optional<ExpressionNode> compileExpression(const ExpressionTree& tree, ValueType type,
                                                const VariableLookup& lookup, int& smoothStates,
                                                ExpressionFindings& findings) {
  Compiler compiler(lookup, smoothStates, findings);
  auto node = compiler.compile(tree);
  return node ? compiler.convert(std::move(*node), type, tree.column) : std::nullopt;
}

Value evaluateExpression(const ExpressionNode& node, EvaluationState& state) {
  switch (node.kind) {
    case Kind::Constant:
      return node.constant;
    case Kind::Input: {
      Value value = state.inputs(node.input);
      value.type = node.type;
      return value;
    }
    case Kind::Custom:
      return state.customs[static_cast<size_t>(node.index)];
    case Kind::Element:
      return elementOf(evaluateExpression(node.children[0], state), node.index);
    case Kind::If:
      return evaluateIf(node, state);
    case Kind::Smooth:
      return Value::ofFloat(evaluateSmooth(node, state));
    case Kind::ToFloat:
      return toFloat(evaluateExpression(node.children[0], state));
    case Kind::ToInt:
      return toInt(evaluateExpression(node.children[0], state));
    case Kind::Call:
      break;
  }
  std::vector<Value> arguments;
  arguments.reserve(node.children.size());
  for (const ExpressionNode& child : node.children)
    arguments.push_back(evaluateExpression(child, state));
  return node.function(arguments, state.context);
}

}  // namespace orris
