// Custom uniforms: a row for each operator and function, and the shapes that packs write.
// Contract: expressions.csv. Iris: IrisOptions, IrisFunctions, CustomUniforms.
#include <gmock/gmock.h>

#include <cmath>

#include <orris/pack/expressions/expression.h>

namespace orris {
namespace {

std::optional<ValueType> typeInTable(const std::string& name) {
  static const std::map<std::string, ValueType> kTypes{
      {"biome", ValueType::Int},           {"isEyeInWater", ValueType::Int},
      {"worldTime", ValueType::Int},       {"rainStrength", ValueType::Float},
      {"frameTime", ValueType::Float},     {"temperature", ValueType::Float},
      {"hideGUI", ValueType::Bool},        {"sunPosition", ValueType::Vec3},
      {"eyeBrightness", ValueType::IVec2}, {"gbufferModelView", ValueType::Mat4}};
  const auto found = kTypes.find(name);
  return found == kTypes.end() ? std::nullopt : std::optional(found->second);
}

Value valueInTable(const std::string& name) {
  Value value;
  if (name == "biome") return Value::ofInt(5);
  if (name == "isEyeInWater") return Value::ofInt(1);
  if (name == "worldTime") return Value::ofInt(13000);
  if (name == "rainStrength") return Value::ofFloat(0.5f);
  if (name == "frameTime") return Value::ofFloat(0.1f);
  if (name == "temperature") return Value::ofFloat(0.25f);
  if (name == "hideGUI") return Value::ofBool(false);
  for (size_t i = 0; i < 16; ++i) value.f[i] = static_cast<float>(i);
  value.i = {120, 240, 0, 0};
  return value;
}

/// The value of one uniform; NAN in the first element when it is dropped.
Value valueOf(const std::string& text, ValueType type) {
  Diagnostics diagnostics;
  CustomUniforms uniforms({{.name = "x", .type = type, .expression = text, .lines = {text}}},
                          typeInTable, diagnostics);
  uniforms.evaluate(valueInTable, 0.1f, 1);
  if (!uniforms.values().empty()) return uniforms.values()[0].second;
  Value dropped;
  dropped.f[0] = NAN;
  dropped.i[0] = -999;
  return dropped;
}

struct NumberCase {
  const char* text;
  float value;  ///< NAN: the uniform is dropped
};

TEST(ExpressionTable, numbers) {
  const NumberCase kCases[] = {
      // Operators.
      {"2 * 3", 6},
      {"7 / 2", 3.5f},
      {"7 % 4", 3},
      {"-7 % 4", -3},
      {"2 + 3", 5},
      {"2 - 3", -1},
      {"-rainStrength", -0.5f},
      {"1 - -1", 2},
      {"8 / 2 / 2", 2},
      {"2 * (3 + 4)", 14},
      {"2*3%4", 2},  // one level, from the left
      {"+1", NAN},
      {"1 +* 2", NAN},
      {"()", NAN},
      {"", NAN},
      {"1;", NAN},
      // Functions of one number.
      {"sin(0)", 0},
      {"cos(0)", 1},
      {"tan(0)", 0},
      {"asin(1)", 1.5707963f},
      {"acos(1)", 0},
      {"atan(1)", 0.7853982f},
      {"torad(180)", 3.1415927f},
      {"radians(180)", 3.1415927f},
      {"todeg(pi)", 180},
      {"degrees(pi)", 180},
      {"exp(0)", 1},
      {"exp2(3)", 8},
      {"exp10(2)", 100},
      {"log(1)", 0},
      {"log2(8)", 3},
      {"log10(1000)", 3},
      {"sqrt(9)", 3},
      {"abs(-2.5)", 2.5f},
      {"sign(-2)", -1},
      {"signum(2)", 1},
      {"sign(0)", 0},
      {"floor(-1.5)", -2},
      {"ceil(1.2)", 2},
      {"frac(1.25)", 0.25f},
      {"frac(-0.25)", 0.75f},
      // Of more.
      {"pow(2, 10)", 1024},
      {"atan(1, 1)", 0.7853982f},
      {"atan2(1, -1)", 2.3561945f},
      {"log(10, 100)", 2},
      {"min(3, 2)", 2},
      // Iris: IrisFunctions looks at the first two, whatever the documentation says.
      {"max(1, 2, 5, 4)", 2},
      {"max(1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16)", 2},
      {"min(3, 2, 1)", 2},
      // Operators by name, casts, a last comma.
      {"add(1, multiply(2, 3))", 7},
      {"subtract(1, divide(1, 4))", 0.75f},
      {"negate(remainder(7, 4))", -3},
      {"toFloat(7)", 7},
      {"toFloat(7.5)", NAN},
      {"5.5 % 2.0", 1.5f},
      {"1d + 2D", 3},
      {"max(1, 2,)", 2},
      {"sin(,)", NAN},
      {"max(1,, 2)", NAN},
      {"sunPosition . y", 1},
      {"gbufferModelView. 3 .1", 13},
      {"sunPosition.", NAN},
      {"clamp(5, 0, 1)", 1},
      {"clamp(-1.5, -1, 1)", -1},
      {"mix(0, 10, 0.25)", 2.5f},
      {"edge(1, 0.5)", 0},
      {"fmod(-1, 4)", 3},
      {"fmod(5, 3)", 2},
      {"if(true, 1, 2)", 1},
      {"if(false, 1, 2)", 2},
      {"if(false, 1, false, 2, 3)", 3},
      {"if(true, 1, 1 / 0)", 1},
      {"sin()", NAN},
      {"sin(1, 2)", NAN},
      {"max(1)", NAN},
      {"clamp(1, 2)", NAN},
      {"if(1, 2, 3)", NAN},
      {"sin(hideGUI)", NAN},
      // OptiFine's own; Iris drops them.
      {"round(1.5)", NAN},
      {"lerp(0.5, 1, 2)", NAN},
      {"ifb(true, true, false)", NAN},
      // Inputs and their elements.
      {"sunPosition.x", 0},
      {"sunPosition.g", 1},
      {"sunPosition.p", 2},
      {"sunPosition.1", 1},
      {"eyeBrightness.y", 240},
      {"gbufferModelView.0.3", 3},
      {"gbufferModelView.3.1", 13},
      {"sunPosition.w", NAN},
      {"sunPosition.xy", NAN},
      {"sunPosition", NAN},
      {"rainStrength.x", NAN},
      {"nothing", NAN},
      {"BIOME_NOWHERE", NAN},
      {"rainstrength", NAN},
      {"hideGUI", NAN},
      // Shapes of real packs.
      {"if(isEyeInWater == 1, 0.2, 1.0)", 0.2f},
      {"if(in(biome, 3, 5, 8), 1, 0)", 1},
      {"smooth(1, if(biome == 5, 1.0, 0.0), 10, 10)", 1},
      {"smooth(if(temperature < 0.15, 1, 0), 5.0)", 0},
      {"clamp((worldTime - 12700) / 300.0, 0, 1)", 1},
      {"max(sunPosition.y / 100.0, 0.0) * (1.0 - rainStrength)", 0.005f},
      {"frac(worldTime / 24000.0) * 2 * pi", 3.4033918f},
      {"if(worldTime > 12000 && worldTime < 24000, 1, rainStrength > 0.9, 2, 3)", 1},
      {"fmod(frameTime * 32.0, 1.0)", 0.2f},
      {"floor(eyeBrightness.y / 16.0)", 15},
      {"sqrt(sunPosition.x * sunPosition.x + sunPosition.y * sunPosition.y)", 1},
      {"exp(-frameTime * 0)", 1},
  };
  for (const NumberCase& test : kCases) {
    const float found = valueOf(test.text, ValueType::Float).f[0];
    if (std::isnan(test.value)) {
      EXPECT_TRUE(std::isnan(found)) << test.text << " = " << found;
    } else {
      EXPECT_NEAR(found, test.value, 1e-4f * std::max(1.0f, std::abs(test.value))) << test.text;
    }
  }
}

struct BoolCase {
  const char* text;
  int value;  ///< -999: the uniform is dropped
};

TEST(ExpressionTable, booleans) {
  const BoolCase kCases[] = {
      {"true", 1},
      {"false", 0},
      {"!true", 0},
      {"!(1 > 2)", 1},
      {"!!true", 1},
      {"1 == 1", 1},
      {"1 != 1", 0},
      {"1 < 2", 1},
      {"2 <= 2", 1},
      {"2 > 2", 0},
      {"2 >= 3", 0},
      {"1 == 1.0", 1},
      {"true == false", 0},
      {"true != false", 1},
      {"2 \u2260 2", 0},
      {"2 \u2265 2", 1},
      {"true || false && false", 0},  // one level, from the left: (true || false) && false
      {"false && true || true", 1},
      {"1 < 2 && 2 < 3", 1},
      {"between(1, 1, 2)", 1},
      {"between(2.5, 1, 2)", 0},
      {"equals(1, 1.2, 0.1)", 0},
      {"in(3, 1, 2, 3)", 1},
      {"in(3.5, 3)", 0},
      {"hideGUI || biome == 5", 1},
      {"true < false", -999},
      {"!1", -999},
      {"1 && 1", -999},
      {"biome = 5", -999},
      {"1", -999},
      {"true & true", -999},
      {"not true", -999},
      {"and(true, not(false))", 1},
      {"or(false, lessThan(1, 2))", 1},
      {"moreThanOrEquals(1, 2)", 0},
      {"notEquals(1, 2)", 1},
      {"equals(1, 1)", 1},
      {"equals(true, false)", 0},
      {"floor(rainStrength) == 0", 1},
      // Iris: ExpressionResolver finds the comparison of ints and that of floats.
      {"floor(rainStrength) == ceil(rainStrength)", -999},
      {"between(floor(0.5), ceil(0.5), abs(floor(1.5)))", -999},
      {"toInt(floor(rainStrength)) == ceil(rainStrength)", 0},
  };
  for (const BoolCase& test : kCases) {
    EXPECT_EQ(valueOf(test.text, ValueType::Bool).i[0], test.value) << test.text;
  }
}

TEST(ExpressionTable, whole_numbers) {
  const BoolCase kCases[] = {
      // Iris: there is no cast from float to int but toInt().
      {"5 / 2", -999},
      {"-0.9", -999},
      {"biome + 0.5", -999},
      {"if(hideGUI, 1.0, 2.0)", -999},
      {"toInt(5 / 2)", 2},
      {"floor(5 / 2)", 2},
      {"1 + floor(5 / 2) * 3", 7},
      {"if(hideGUI, 1, ceil(rainStrength))", 1},
      {"min(floor(2.5), 3) % 2", 0},
      {"floor(1.5) + 0.5", -999},
      {"fmod(-7, 4)", 1},
      {"floor(2.7)", 2},
      {"ceil(2.1)", 3},
      {"0x10", 16},
      {"0b11", 3},
      {"010", 8},
      {"7 % 4 * 2", 6},
      {"max(1, 2)", 2},
      {"clamp(9, 0, 5)", 5},
      {"abs(-4)", 4},
      {"fmod(7, 4)", 3},
      {"if(hideGUI, 1, biome)", 5},
      {"true", -999},
      {"0x", -999},
      {"1_000", -999},
  };
  for (const BoolCase& test : kCases) {
    EXPECT_EQ(valueOf(test.text, ValueType::Int).i[0], test.value) << test.text;
  }
}

struct VectorCase {
  const char* text;
  ValueType type;
  std::vector<float> value;  ///< NAN: dropped
};

TEST(ExpressionTable, vectors) {
  const VectorCase kCases[] = {
      {"vec2(1, 2.5)", ValueType::Vec2, {1, 2.5f}},
      {"vec3(1, 2, 3)", ValueType::Vec3, {1, 2, 3}},
      {"vec4(1, 2, 3, rainStrength)", ValueType::Vec4, {1, 2, 3, 0.5f}},
      {"vec3(1, 2, 3) + sunPosition", ValueType::Vec3, {1, 3, 5}},
      {"vec2(4, 6) / vec2(2, 3)", ValueType::Vec2, {2, 2}},
      {"-sunPosition", ValueType::Vec3, {0, -1, -2}},
      {"abs(vec2(-1, 2))", ValueType::Vec2, {1, 2}},
      {"floor(vec2(1.5, -1.5))", ValueType::Vec2, {1, -2}},
      {"max(vec2(1, 5), vec2(3, 2))", ValueType::Vec2, {3, 5}},
      {"clamp(vec2(-1, 5), vec2(0, 0), vec2(1, 2))", ValueType::Vec2, {0, 2}},
      {"if(hideGUI, vec2(1, 1), vec2(2, 3))", ValueType::Vec2, {2, 3}},
      {"vec3(1)", ValueType::Vec3, {NAN}},
      {"vec3(vec2(1, 2), 3)", ValueType::Vec3, {NAN}},
      {"vec2(1, 2) * 2", ValueType::Vec2, {NAN}},
      {"vec2(1, 2)", ValueType::Vec3, {NAN}},
      {"vec2(1, 2).x", ValueType::Float, {NAN}},  // elements of named values only
      {"1", ValueType::Vec2, {NAN}},
  };
  for (const VectorCase& test : kCases) {
    const Value found = valueOf(test.text, test.type);
    if (std::isnan(test.value[0])) {
      EXPECT_TRUE(std::isnan(found.f[0])) << test.text;
      continue;
    }
    for (size_t i = 0; i < test.value.size(); ++i) {
      EXPECT_FLOAT_EQ(found.f[i], test.value[i]) << test.text;
    }
  }
}

}  // namespace
}  // namespace orris
