#include <orris/pack/expressions/expression_functions.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace orris {
namespace {

using Arguments = std::span<const Value>;

constexpr size_t kMostCompared = 16;

/// Operators as functions. Iris: IrisOptions.
struct OperatorName {
  std::string_view function, sign;
};
constexpr OperatorName kOperatorNames[] = {{"add", "+"},
                                           {"subtract", "-"},
                                           {"multiply", "*"},
                                           {"divide", "/"},
                                           {"remainder", "%"},
                                           {"negate", "neg"},
                                           {"not", "!"},
                                           {"and", "&&"},
                                           {"or", "||"},
                                           {"equals", "=="},
                                           {"notEquals", "!="},
                                           {"lessThan", "<"},
                                           {"moreThan", ">"},
                                           {"lessThanOrEquals", "<="},
                                           {"moreThanOrEquals", ">="}};

/// "+" for "add", else the name itself.
std::string_view signOf(std::string_view name) {
  const auto known = std::find_if(std::begin(kOperatorNames), std::end(kOperatorNames),
                                  [&](const OperatorName& row) { return row.function == name; });
  return known == std::end(kOperatorNames) ? name : known->sign;
}

bool isWhole(const Value& value) {
  return value.type == ValueType::Bool || value.type == ValueType::Int ||
         value.type == ValueType::IVec2 || value.type == ValueType::IVec3;
}

int wrap(long long value) { return static_cast<int>(static_cast<std::uint32_t>(value)); }

/// Applies one of two operations to each component of arguments of equal type.
template <typename OnInt, typename OnFloat>
Value componentwise(Arguments a, OnInt onInt, OnFloat onFloat) {
  Value result = a[0];
  for (size_t c = 0; c < static_cast<size_t>(componentCount(a[0].type)); ++c) {
    const auto at = [&](size_t argument) { return argument < a.size() ? argument : 0; };
    if (isWhole(a[0])) {
      result.i[c] =
          wrap(onInt(static_cast<long long>(a[0].i[c]), static_cast<long long>(a[at(1)].i[c]),
                     static_cast<long long>(a[at(2)].i[c])));
    } else {
      result.f[c] = onFloat(a[0].f[c], a[at(1)].f[c], a[at(2)].f[c]);
    }
  }
  return result;
}

template <typename Operation>
Value both(Arguments a, Operation operation) {
  return componentwise(
      a, [&](long long x, long long y, long long z) { return operation(x, y, z); },
      [&](float x, float y, float z) { return operation(x, y, z); });
}

/// float(float)
template <float (*Function)(float)>
Value unary(Arguments a, EvaluationContext&) {
  return both(a, [](auto x, auto, auto) { return Function(static_cast<float>(x)); });
}

float compare(const Value& a, const Value& b) {
  const double x = isWhole(a) ? a.i[0] : static_cast<double>(a.f[0]);
  const double y = isWhole(b) ? b.i[0] : static_cast<double>(b.f[0]);
  return x < y ? -1.0f : x > y ? 1.0f : x == y ? 0.0f : std::numeric_limits<float>::quiet_NaN();
}

float radians(float x) { return x * std::numbers::pi_v<float> / 180; }
float degrees(float x) { return x * 180 / std::numbers::pi_v<float>; }
float exp10f(float x) { return std::pow(10.0f, x); }
float signum(float x) { return x > 0 ? 1.0f : x < 0 ? -1.0f : 0.0f; }
float fraction(float x) { return x - std::floor(x); }

std::uint32_t nextRandom(EvaluationContext& context) {
  // PCG: one multiplication for the state, a mixed output.
  context.random = context.random * 747796405u + 2891336453u;
  const std::uint32_t word =
      ((context.random >> ((context.random >> 28) + 4)) ^ context.random) * 277803737u;
  return (word >> 22) ^ word;
}
float nextUnit(EvaluationContext& context) {
  return static_cast<float>(nextRandom(context) >> 8) * 0x1p-24f;
}

Value randomFloat(Arguments a, EvaluationContext& context) {
  const float unit = nextUnit(context);
  return Value::ofFloat(a.empty() ? unit : a[0].f[0] + unit * (a[1].f[0] - a[0].f[0]));
}

Value randomInt(Arguments a, EvaluationContext& context) {
  if (a.empty()) return Value::ofInt(static_cast<int>(nextRandom(context)));
  const long long low = a.size() > 1 ? a[0].i[0] : 0;
  const long long span = a.back().i[0] - low;
  const long long offset = span > 0 ? static_cast<long long>(nextRandom(context)) % span : 0;
  return Value::ofInt(wrap(low + offset));
}

Value vectorOf(Arguments a, EvaluationContext&) {
  Value result;
  result.type = a.size() == 2 ? ValueType::Vec2 : a.size() == 3 ? ValueType::Vec3 : ValueType::Vec4;
  for (size_t c = 0; c < a.size(); ++c) result.f[c] = a[c].f[0];
  return result;
}

Value isIn(Arguments a, EvaluationContext&) {
  return Value::ofBool(
      std::any_of(a.begin() + 1, a.end(), [&](const Value& v) { return v.f[0] == a[0].f[0]; }));
}

/// One family of overloads. `parameters` and `result` use b i f 2 3 4 for types and T for each type
/// of `family` in turn; a trailing '*' repeats the last parameter up to `most` arguments.
struct Row {
  std::string_view name, parameters, family;
  char result;
  ExpressionFunction function;
  size_t most = 0;
};

#define ORRIS_BOTH(expression)                  \
  [](Arguments a, EvaluationContext&) {         \
    return both(a, [](auto x, auto y, auto z) { \
      (void)y;                                  \
      (void)z;                                  \
      return expression;                        \
    });                                         \
  }
#define ORRIS_TEST(expression) \
  [](Arguments a, EvaluationContext&) { return Value::ofBool(expression); }

const std::vector<Row>& rows() {
  static const std::vector<Row> kRows{
      {"+", "TT", "if234", 'T', ORRIS_BOTH(x + y)},
      {"-", "TT", "if234", 'T', ORRIS_BOTH(x - y)},
      {"*", "TT", "if234", 'T', ORRIS_BOTH(x * y)},
      {"/", "TT", "f234", 'T', ORRIS_BOTH(x / y)},
      {"%", "ii", "", 'i',
       [](Arguments a, EvaluationContext&) {
         return Value::ofInt(a[1].i[0] == 0 ? 0
                                            : wrap(static_cast<long long>(a[0].i[0]) % a[1].i[0]));
       }},
      {"%", "ff", "", 'f',
       [](Arguments a, EvaluationContext&) {
         return Value::ofFloat(std::fmod(a[0].f[0], a[1].f[0]));
       }},
      {"neg", "T", "if234", 'T', ORRIS_BOTH(-x)},
      {"!", "b", "", 'b', ORRIS_TEST(a[0].i[0] == 0)},
      {"&&", "bb", "", 'b', ORRIS_TEST(a[0].i[0] != 0 && a[1].i[0] != 0)},
      {"||", "bb", "", 'b', ORRIS_TEST(a[0].i[0] != 0 || a[1].i[0] != 0)},
      {"==", "TT", "ifb", 'b', ORRIS_TEST(compare(a[0], a[1]) == 0)},
      {"!=", "TT", "ifb", 'b', ORRIS_TEST(compare(a[0], a[1]) != 0)},
      {"<", "TT", "if", 'b', ORRIS_TEST(compare(a[0], a[1]) < 0)},
      {">", "TT", "if", 'b', ORRIS_TEST(compare(a[0], a[1]) > 0)},
      {"<=", "TT", "if", 'b', ORRIS_TEST(compare(a[0], a[1]) <= 0)},
      {">=", "TT", "if", 'b', ORRIS_TEST(compare(a[0], a[1]) >= 0)},
      {"sin", "f", "", 'f', unary<std::sin>},
      {"cos", "f", "", 'f', unary<std::cos>},
      {"tan", "f", "", 'f', unary<std::tan>},
      {"asin", "f", "", 'f', unary<std::asin>},
      {"acos", "f", "", 'f', unary<std::acos>},
      {"atan", "f", "", 'f', unary<std::atan>},
      {"atan", "ff", "", 'f', ORRIS_BOTH(std::atan2(x, y))},
      {"atan2", "ff", "", 'f', ORRIS_BOTH(std::atan2(x, y))},
      {"torad", "f", "", 'f', unary<radians>},
      {"radians", "f", "", 'f', unary<radians>},
      {"todeg", "f", "", 'f', unary<degrees>},
      {"degrees", "f", "", 'f', unary<degrees>},
      {"exp", "f", "", 'f', unary<std::exp>},
      {"exp2", "f", "", 'f', unary<std::exp2>},
      {"exp10", "f", "", 'f', unary<exp10f>},
      {"log", "f", "", 'f', unary<std::log>},
      {"log2", "f", "", 'f', unary<std::log2>},
      {"log10", "f", "", 'f', unary<std::log10>},
      {"log", "ff", "", 'f', ORRIS_BOTH(std::log(y) / std::log(x))},
      {"pow", "ff", "", 'f', ORRIS_BOTH(std::pow(x, y))},
      {"sqrt", "f", "", 'f', unary<std::sqrt>},
      {"abs", "T", "if234", 'T', ORRIS_BOTH(x < 0 ? -x : x)},
      {"sign", "f", "", 'f', unary<signum>},
      {"signum", "f", "", 'f', unary<signum>},
      {"floor", "T", "f234", 'T', unary<std::floor>},
      {"ceil", "T", "f234", 'T', unary<std::ceil>},
      {"frac", "f", "", 'f', unary<fraction>},
      {"min", "TT", "if234", 'T', ORRIS_BOTH(std::min(x, y))},
      {"max", "TT", "if234", 'T', ORRIS_BOTH(std::max(x, y))},
      // Iris: IrisFunctions, which looks at the second argument again and again (isCutShort()).
      {"min", "TTT*", "if", 'T', ORRIS_BOTH(std::min(x, y)), kMostCompared},
      {"max", "TTT*", "if", 'T', ORRIS_BOTH(std::max(x, y)), kMostCompared},
      {"clamp", "TTT", "if234", 'T', ORRIS_BOTH(std::min(std::max(x, y), z))},
      {"mix", "fff", "", 'f', ORRIS_BOTH(x + (y - x) * z)},
      {"edge", "TT", "if", 'T', ORRIS_BOTH(y < x ? decltype(x)(0) : decltype(x)(1))},
      {"fmod", "ii", "", 'i',
       [](Arguments a, EvaluationContext&) {
         const long long x = a[0].i[0], y = a[1].i[0];
         return Value::ofInt(y == 0 ? 0 : wrap((x % y + y) % y));
       }},
      {"fmod", "ff", "", 'f',
       [](Arguments a, EvaluationContext&) {
         return Value::ofFloat(a[0].f[0] - a[1].f[0] * std::floor(a[0].f[0] / a[1].f[0]));
       }},
      {"random", "", "", 'f', randomFloat},
      {"random", "ff", "", 'f', randomFloat},
      {"randomInt", "", "", 'i', randomInt},
      {"randomInt", "i", "", 'i', randomInt},
      {"randomInt", "ii", "", 'i', randomInt},
      {"between", "TTT", "if", 'b',
       ORRIS_TEST(compare(a[0], a[1]) >= 0 && compare(a[0], a[2]) <= 0)},
      {"equals", "fff", "", 'b', ORRIS_TEST(std::abs(a[0].f[0] - a[1].f[0]) <= a[2].f[0])},
      {"in", "ff*", "", 'b', isIn, 32},
      {"toInt", "f", "", 'i', [](Arguments a, EvaluationContext&) { return toInt(a[0]); }},
      {"toFloat", "i", "", 'f', [](Arguments a, EvaluationContext&) { return toFloat(a[0]); }},
      {"vec2", "ff", "", '2', vectorOf},
      {"vec3", "fff", "", '3', vectorOf},
      {"vec4", "ffff", "", '4', vectorOf},
  };
  return kRows;
}
#undef ORRIS_BOTH
#undef ORRIS_TEST

ValueType typeOf(char letter, char family) {
  switch (letter == 'T' ? family : letter) {
    case 'b':
      return ValueType::Bool;
    case 'i':
      return ValueType::Int;
    case '2':
      return ValueType::Vec2;
    case '3':
      return ValueType::Vec3;
    case '4':
      return ValueType::Vec4;
    default:
      return ValueType::Float;
  }
}

/// The parameter types of a row for `count` arguments; nullopt when it takes another number.
std::optional<std::vector<ValueType>> parametersOf(const Row& row, char family, size_t count) {
  std::string_view letters = row.parameters;
  const bool repeats = letters.ends_with('*');
  if (repeats) letters.remove_suffix(1);
  if (repeats ? count < letters.size() || count > row.most : count != letters.size())
    return std::nullopt;
  std::vector<ValueType> types;
  for (size_t i = 0; i < count; ++i)
    types.push_back(typeOf(letters[std::min(i, letters.size() - 1)], family));
  return types;
}

bool accepts(std::span<const ValueType> parameters, std::span<const ValueType> arguments) {
  return std::equal(parameters.begin(), parameters.end(), arguments.begin(), arguments.end(),
                    [](ValueType parameter, ValueType argument) {
                      return parameter == argument ||
                             (parameter == ValueType::Float && argument == ValueType::Int);
                    });
}

}  // namespace

std::vector<std::string_view> expressionFunctionNames() {
  std::vector<std::string_view> names{"if", "smooth"};
  for (const Row& row : rows()) names.push_back(row.name);
  for (const OperatorName& row : kOperatorNames) names.push_back(row.function);
  return names;
}

bool isExpressionFunction(std::string_view name) {
  if (name == "if" || name == "smooth") return true;
  const std::string_view sign = signOf(name);
  return std::any_of(rows().begin(), rows().end(),
                     [&](const Row& row) { return row.name == name || row.name == sign; });
}

bool isCutShort(std::string_view name, size_t arguments) {
  return (name == "min" || name == "max") && arguments > 2;
}

bool mayBeInt(std::string_view name) {
  constexpr std::string_view kNames[] = {"+",   "-",   "*",     "%",    "neg", "abs",
                                         "min", "max", "clamp", "edge", "fmod"};
  return std::ranges::find(kNames, signOf(name)) != std::end(kNames);
}

bool isAmbiguous(std::string_view name) {
  constexpr std::string_view kNames[] = {"==", "!=", "<", ">", "<=", ">=", "between"};
  return std::ranges::find(kNames, signOf(name)) != std::end(kNames);
}

ExpressionOverload findOverload(std::string_view name, std::span<const ValueType> arguments) {
  const std::string_view sign = signOf(name);
  for (const Row& row : rows()) {
    if (row.name != name && row.name != sign) continue;
    for (const char family : row.family.empty() ? std::string_view("f") : row.family) {
      auto parameters = parametersOf(row, family, arguments.size());
      if (!parameters || !accepts(*parameters, arguments)) continue;
      return {row.function, std::move(*parameters), typeOf(row.result, family)};
    }
  }
  return {};
}

int componentCount(ValueType type) {
  constexpr int kCounts[] = {1, 1, 1, 2, 3, 4, 2, 3, 9, 16};
  return kCounts[static_cast<size_t>(type)];
}

std::string_view typeName(ValueType type) {
  constexpr std::string_view kNames[] = {"bool", "int",   "float", "vec2", "vec3",
                                         "vec4", "ivec2", "ivec3", "mat3", "mat4"};
  return kNames[static_cast<size_t>(type)];
}

Value toFloat(const Value& value) {
  return value.type == ValueType::Int ? Value::ofFloat(static_cast<float>(value.i[0])) : value;
}

Value toInt(const Value& value) {
  if (value.type != ValueType::Float) return value;
  const double x = value.f[0];
  if (std::isnan(x)) return Value::ofInt(0);
  return Value::ofInt(static_cast<int>(
      std::clamp<double>(x, std::numeric_limits<int>::min(), std::numeric_limits<int>::max())));
}

}  // namespace orris
