// The functions and operators of custom uniforms. Contract: expressions.csv.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include <orris/pack/expressions/expression.h>

namespace orris {

/// What a function may depend on besides its arguments.
struct EvaluationContext {
  float frameTime = 0;
  std::uint32_t random = 0;  ///< state of the generator behind random()
};

using ExpressionFunction = Value (*)(std::span<const Value> arguments, EvaluationContext& context);

/// A function for certain argument types; an argument of type int may be passed where a float is
/// wanted.
struct ExpressionOverload {
  ExpressionFunction function = nullptr;
  std::vector<ValueType> parameters;
  ValueType result = ValueType::Float;
};

/// Names of the functions, and the signs of the operators ("neg" for the prefix minus), which have
/// names as functions, too ("add").
std::vector<std::string_view> expressionFunctionNames();

/// Is there a function of that name at all?
bool isExpressionFunction(std::string_view name);

/// Iris looks at the first two arguments only of min and max of more.
bool isCutShort(std::string_view name, std::size_t arguments);
/// Is the function, of arguments that are all int, an int?
bool mayBeInt(std::string_view name);
/// Does Iris find two meanings when each argument is both int and float (floor(), ceil())?
bool isAmbiguous(std::string_view name);

/// The overload for these argument types; function nullptr when there is none.
ExpressionOverload findOverload(std::string_view name, std::span<const ValueType> arguments);

/// How many numbers a value of the type has.
int componentCount(ValueType type);
std::string_view typeName(ValueType type);

/// Int to float; anything else is returned as it is.
Value toFloat(const Value& value);
/// Float to int, cut off towards zero and at the ends of the range.
Value toInt(const Value& value);

}  // namespace orris
