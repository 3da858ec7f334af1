// A type-checked expression that can be evaluated each frame. Contract: expressions.csv.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <orris/pack/expressions/expression_functions.h>
#include <orris/pack/expressions/expression_parser.h>

namespace orris {

/// Where a name gets its value.
struct ExpressionVariable {
  ValueType type = ValueType::Float;
  int custom = -1;  ///< index of a custom uniform, -1 for an input of the host
};

/// The state of one smooth() call.
struct SmoothState {
  bool started = false;
  float value = 0;
};

/// One node with its type; children are converted to what the node wants.
struct ExpressionNode {
  enum class Kind { Constant, Input, Custom, Element, Call, If, Smooth, ToFloat, ToInt };
  Kind kind = Kind::Constant;
  ValueType type = ValueType::Float;
  /// Of a float: Iris takes it as int where an int is wanted, for it is made of floor(), ceil() and
  /// ints; `isEither` when no int is needed for that. Iris: ExpressionResolver.
  bool isWhole = false, isEither = false;
  Value constant;
  std::string input;
  int index = 0;  ///< custom uniform, element, or smooth state
  ExpressionFunction function = nullptr;
  std::vector<ExpressionNode> children;
};

using VariableLookup = std::function<std::optional<ExpressionVariable>(const std::string&)>;

/// What compileExpression() found: `error` when there is no program, else what works otherwise than
/// its author thinks.
struct ExpressionFindings {
  ExpressionError error;
  std::vector<ExpressionError> slips;
};

/// Checks `tree` and converts its result to `type`. `smoothStates` counts the smooth() calls of all
/// expressions. nullopt and an error when a name, function or type does not fit.
std::optional<ExpressionNode> compileExpression(const ExpressionTree& tree, ValueType type,
                                                const VariableLookup& lookup, int& smoothStates,
                                                ExpressionFindings& findings);

/// Everything that an evaluation reads and writes.
struct EvaluationState {
  const InputValues& inputs;
  const std::vector<Value>& customs;
  std::vector<SmoothState>& smooth;
  EvaluationContext context;
};

Value evaluateExpression(const ExpressionNode& node, EvaluationState& state);

}  // namespace orris
