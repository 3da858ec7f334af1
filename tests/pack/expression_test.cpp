#include <orris/pack/expressions/expression.h>

#include <gmock/gmock.h>

#include <cmath>

namespace orris {
namespace {

using testing::FloatNear;

std::optional<ValueType> inputType(const std::string& name) {
  static const std::map<std::string, ValueType> kTypes{
      {"count", ValueType::Int},     {"time", ValueType::Float},  {"wet", ValueType::Bool},
      {"position", ValueType::Vec3}, {"light", ValueType::IVec2}, {"view", ValueType::Mat4}};
  const auto found = kTypes.find(name);
  return found == kTypes.end() ? std::nullopt : std::optional(found->second);
}

Value inputValue(const std::string& name) {
  Value value;
  if (name == "count") return Value::ofInt(7);
  if (name == "wet") return Value::ofBool(true);
  if (name == "time") return Value::ofFloat(0.5f);
  for (size_t i = 0; i < 16; ++i) value.f[i] = static_cast<float>(i);
  value.i = {100, 200, 0, 0};
  return value;
}

/// Evaluates one uniform of the type; a dropped one gives its message in `error`.
std::optional<Value> evaluate(const std::string& text, ValueType type,
                              std::string* error = nullptr) {
  Diagnostics diagnostics;
  CustomUniforms uniforms({{.name = "x", .type = type, .expression = text, .lines = {text}}},
                          inputType, diagnostics);
  uniforms.evaluate(inputValue, 0.1f, 1);
  if (error) *error = diagnostics.empty() ? "" : diagnostics[0].message;
  return uniforms.values().empty() ? std::nullopt : std::optional(uniforms.values()[0].second);
}

float number(const std::string& text) {
  const auto value = evaluate(text, ValueType::Float);
  return value ? value->f[0] : NAN;
}

int whole(const std::string& text) {
  const auto value = evaluate(text, ValueType::Int);
  return value ? value->i[0] : -999;
}

bool isTrue(const std::string& text) {
  const auto value = evaluate(text, ValueType::Bool);
  EXPECT_TRUE(value) << text;
  return value && value->i[0] != 0;
}

std::string problem(const std::string& text, ValueType type = ValueType::Float) {
  std::string error;
  evaluate(text, type, &error);
  return error;
}

TEST(Expression, operators_bind_as_the_contract_says) {
  EXPECT_EQ(whole("2 + 3 * 4"), 14);
  EXPECT_EQ(whole("(2 + 3) * 4"), 20);
  EXPECT_EQ(whole("10 - 3 - 2"), 5);
  EXPECT_EQ(whole("-2 * -3"), 6);
  EXPECT_EQ(whole("- -2"), 2);
  EXPECT_TRUE(isTrue("1 + 1 == 2 && 3 > 2"));
  EXPECT_TRUE(isTrue("!false && !(1 > 2)"));
}

TEST(Expression, and_and_or_have_one_precedence) {
  EXPECT_FALSE(isTrue("true || true && false"));
  EXPECT_TRUE(isTrue("true || (true && false)"));
}

TEST(Expression, division_is_always_in_floats) {
  EXPECT_FLOAT_EQ(number("5 / 2"), 2.5f);
  EXPECT_EQ(whole("toInt(5 / 2)"), 2);
  EXPECT_EQ(whole("-7 % 4"), -3);
  EXPECT_EQ(whole("7 % 0"), 0);
  EXPECT_FLOAT_EQ(number("5.5 % 2.0"), 1.5f);
}

TEST(Expression, numbers_in_all_their_forms) {
  EXPECT_EQ(whole("0x1F"), 31);
  EXPECT_EQ(whole("0b101"), 5);
  EXPECT_EQ(whole("010"), 8);
  EXPECT_FLOAT_EQ(number(".5"), 0.5f);
  EXPECT_FLOAT_EQ(number("2.5f"), 2.5f);
  EXPECT_FLOAT_EQ(number("1e3"), 1000);
  EXPECT_FLOAT_EQ(number("pi"), 3.14159265f);
  EXPECT_FLOAT_EQ(number("3000000000"), 3e9f);
}

TEST(Expression, int_becomes_float_and_float_no_int) {
  EXPECT_FLOAT_EQ(number("count + 0.5"), 7.5f);
  EXPECT_EQ(whole("toInt(count + 0.9)"), 7);
  EXPECT_EQ(whole("toInt(-0.9)"), 0);
  EXPECT_EQ(whole("toInt(1e30)"), 2147483647);
  EXPECT_EQ(problem("count + 0.9", ValueType::Int),
            "custom uniform x is dropped: expected int, found float; write toInt(), floor() or "
            "ceil() around it");
  EXPECT_EQ(problem("true"), "custom uniform x is dropped: expected float, found bool");
  EXPECT_EQ(problem("wet + 1"), "custom uniform x is dropped: + does not take (bool, int)");
}

TEST(Expression, elements_of_vectors_and_matrices) {
  EXPECT_FLOAT_EQ(number("position.y"), 1);
  EXPECT_FLOAT_EQ(number("position.b"), 2);
  EXPECT_FLOAT_EQ(number("position.0"), 0);
  EXPECT_EQ(whole("light.y"), 200);
  EXPECT_EQ(problem("position.w"),
            "custom uniform x is dropped: position is vec3; it has no element .w");
  EXPECT_EQ(problem("time.x"), "custom uniform x is dropped: time is float; it has no element .x");
}

TEST(Expression, first_index_of_a_matrix_is_the_column) {
  EXPECT_FLOAT_EQ(number("view.1.2"), 6);
  EXPECT_FLOAT_EQ(number("view.3.x"), 12);
  EXPECT_NE(problem("view.1"), "");
}

TEST(Expression, functions) {
  EXPECT_FLOAT_EQ(number("clamp(3, 0, 2)"), 2);
  EXPECT_FLOAT_EQ(number("max(5, 1, 3)"), 5);
  EXPECT_FLOAT_EQ(number("min(4.0, 2, 1)"), 2);
  EXPECT_EQ(problem("1 + min(4.0, 2, 1)"),
            "Iris looks at the first two of these 3 arguments of min only");
  EXPECT_FLOAT_EQ(number("mix(1, 3, 0.25)"), 1.5f);
  EXPECT_FLOAT_EQ(number("fmod(-1, 3)"), 2);
  EXPECT_FLOAT_EQ(number("frac(-0.25)"), 0.75f);
  EXPECT_FLOAT_EQ(number("edge(2, 1)"), 0);
  EXPECT_FLOAT_EQ(number("edge(2, 2)"), 1);
  EXPECT_FLOAT_EQ(number("log(2, 8)"), 3);
  EXPECT_FLOAT_EQ(number("atan2(1, 1)"), 0.78539816f);
  EXPECT_FLOAT_EQ(number("torad(180)"), 3.14159265f);
  EXPECT_FLOAT_EQ(number("abs(-3)"), 3);
  EXPECT_FLOAT_EQ(number("sign(-3)"), -1);
  EXPECT_TRUE(isTrue("between(2, 1, 2)"));
  EXPECT_TRUE(isTrue("equals(1.0, 1.05, 0.1)"));
  EXPECT_TRUE(isTrue("in(count, 1, 7, 9)"));
  EXPECT_FALSE(isTrue("in(count, 1, 9)"));
  EXPECT_TRUE(isTrue("2 \u2264 3"));
}

TEST(Expression, if_takes_the_first_true_branch_only) {
  EXPECT_EQ(whole("if(false, 1, count == 7, 2, 3)"), 2);
  EXPECT_FLOAT_EQ(number("if(wet, 1, 2.5)"), 1);
  EXPECT_EQ(problem("if(wet, 1)"),
            "custom uniform x is dropped: if takes 3, 5, ... 33 arguments, not 2");
  EXPECT_NE(problem("if(1, 2, 3)"), "");
}

TEST(Expression, vectors_are_made_and_combined) {
  const auto value = evaluate("vec3(1, 2, 3) * position", ValueType::Vec3);
  ASSERT_TRUE(value);
  EXPECT_FLOAT_EQ(value->f[1], 2);
  EXPECT_FLOAT_EQ(value->f[2], 6);
  EXPECT_NE(problem("vec3(1, 2, 3) * 2", ValueType::Vec3), "");
}

TEST(Expression, number_of_arguments_is_checked) {
  EXPECT_EQ(problem("clamp()"), "custom uniform x is dropped: clamp does not take ()");
  EXPECT_NE(problem("sin(1, 2)"), "");
  EXPECT_NE(problem("in(1)"), "");
}

TEST(Expression, what_does_not_parse_is_dropped_with_its_place) {
  EXPECT_EQ(problem("1 +"), "custom uniform x is dropped: the expression ends too early");
  EXPECT_EQ(problem("1 2"), "custom uniform x is dropped: expected an operator or the end");
  EXPECT_EQ(problem("sin(1"), "custom uniform x is dropped: expected , or )");
  EXPECT_EQ(problem("12z"), "custom uniform x is dropped: \"12z\" is no number");
  EXPECT_EQ(problem("round(1.5)"), "custom uniform x is dropped: unknown function round");
  EXPECT_EQ(problem(std::string(10000, '(')), "custom uniform x is dropped: nested deeper than 64");
}

TEST(Expression, long_sums_end_at_a_limit) {
  std::string text = "1";
  for (int i = 0; i < 100000; ++i) text += "+1";
  EXPECT_THAT(problem(text), testing::HasSubstr("more than 8192 terms"));
}

TEST(Expression, smooth_halves_the_distance_each_half_life) {
  Diagnostics diagnostics;
  float target = 0;
  CustomUniforms uniforms(
      {{.name = "x", .type = ValueType::Float, .expression = "smooth(time, 10, 20)"}}, inputType,
      diagnostics);
  const auto step = [&](float seconds) {
    uniforms.evaluate([&](const std::string&) { return Value::ofFloat(target); }, seconds, 1);
    return uniforms.values()[0].second.f[0];
  };
  EXPECT_FLOAT_EQ(step(1), 0);
  target = 1;
  EXPECT_FLOAT_EQ(step(1), 0.5f);
  EXPECT_FLOAT_EQ(step(1), 0.75f);
  target = 0;
  EXPECT_FLOAT_EQ(step(2), 0.375f);
}

TEST(Expression, smooth_with_an_id_and_without_half_life) {
  EXPECT_FLOAT_EQ(number("smooth(3, time, 1, 2)"), 0.5f);
  EXPECT_FLOAT_EQ(number("smooth(3, time)"), 0.5f);
  EXPECT_FLOAT_EQ(number("smooth(time, 0)"), 0.5f);
}

TEST(Expression, random_follows_the_seed) {
  Diagnostics diagnostics;
  CustomUniforms uniforms({{.name = "x", .type = ValueType::Float, .expression = "random(2, 4)"}},
                          inputType, diagnostics);
  const auto draw = [&](unsigned seed) {
    uniforms.evaluate(inputValue, 0, seed);
    return uniforms.values()[0].second.f[0];
  };
  const float first = draw(1);
  EXPECT_EQ(first, draw(1));
  EXPECT_NE(first, draw(2));
  EXPECT_GE(first, 2);
  EXPECT_LT(first, 4);
}

CustomUniform entry(const char* name, const char* text, int line, bool uploaded = true) {
  return {.name = name,
          .type = ValueType::Float,
          .uploaded = uploaded,
          .expression = text,
          .at = {"/p", line, 1},
          .lines = {std::string(name) + " = " + text}};
}

TEST(CustomUniforms, are_evaluated_in_dependency_order_and_variables_stay) {
  Diagnostics diagnostics;
  CustomUniforms uniforms(
      {entry("c", "b * 2", 1), entry("b", "a + 1", 2, false), entry("a", "time", 3)}, inputType,
      diagnostics);
  uniforms.evaluate(inputValue, 0, 1);
  ASSERT_EQ(uniforms.values().size(), 2u);
  EXPECT_EQ(uniforms.values()[0].first, "a");
  EXPECT_EQ(uniforms.values()[1].first, "c");
  EXPECT_FLOAT_EQ(uniforms.values()[1].second.f[0], 3);
  EXPECT_TRUE(diagnostics.empty());
}

TEST(CustomUniforms, a_dropped_entry_takes_its_dependents_along) {
  Diagnostics diagnostics;
  CustomUniforms uniforms({entry("b", "a + 1", 1), entry("a", "nothing", 2), entry("c", "1", 3)},
                          inputType, diagnostics);
  ASSERT_EQ(uniforms.values().size(), 1u);
  EXPECT_EQ(uniforms.values()[0].first, "c");
  ASSERT_EQ(diagnostics.size(), 2u);
  EXPECT_EQ(
      formatDiagnostic(diagnostics[0]),
      "/p:2:5: warning: custom uniform a is dropped: unknown name nothing\n  a = nothing\n      ^");
  EXPECT_EQ(diagnostics[1].message, "custom uniform b is dropped: it uses a, which is dropped");
}

TEST(CustomUniforms, a_mistake_is_shown_at_its_character) {
  Diagnostics diagnostics;
  CustomUniforms uniforms({{.name = "x",
                            .expression = "1 + time * (time + nothing)",
                            .at = {"/p", 4, 1},
                            .lines = {"uniform.float.x = 1 + time \\", "  * (time + nothing)"}}},
                          inputType, diagnostics);
  ASSERT_EQ(diagnostics.size(), 1u);
  EXPECT_EQ(formatDiagnostic(diagnostics[0]),
            "/p:5:13: warning: custom uniform x is dropped: unknown name nothing\n"
            "    * (time + nothing)\n              ^");
  EXPECT_EQ(diagnostics[0].effect, Effect::IgnoresLine);
}

TEST(CustomUniforms, a_circle_is_an_error_that_names_its_members) {
  Diagnostics diagnostics;
  CustomUniforms uniforms(
      {entry("a", "b", 1), entry("b", "c", 2), entry("c", "a", 3), entry("d", "1", 4)}, inputType,
      diagnostics);
  ASSERT_EQ(diagnostics.size(), 1u);
  EXPECT_EQ(diagnostics[0].severity, Severity::Error);
  EXPECT_EQ(diagnostics[0].message,
            "custom uniforms depend on each other in a circle: a, b, c; "
            "Iris refuses the whole pack");
  EXPECT_EQ(diagnostics[0].effect, Effect::RefusesPack);
  EXPECT_EQ(uniforms.values().size(), 1u);
}

TEST(CustomUniforms, a_name_of_the_host_is_not_taken) {
  Diagnostics diagnostics;
  CustomUniforms uniforms({entry("time", "1", 1)}, inputType, diagnostics);
  EXPECT_TRUE(uniforms.values().empty());
  ASSERT_EQ(diagnostics.size(), 1u);
  EXPECT_EQ(diagnostics[0].message,
            "custom uniform time is dropped: time is a uniform of the host");
}

}  // namespace
}  // namespace orris
