#include <orris/glsl/preprocess/condition.h>

#include <gtest/gtest.h>

#include "glsl/glsl_test.h"

namespace orris {
namespace {

using test::preprocessed;

// "1" or "0", or the diagnostics.
std::string evaluate(const std::string& expression, const std::string& definitions = "") {
  return preprocessed(definitions + "#if " + expression + "\n1\n#else\n0\n#endif\n");
}

TEST(condition, arithmetic_has_the_precedence_of_c) {
  EXPECT_EQ(evaluate("1 + 2 * 3 == 7 && 7 - 2 - 1 == 4"), "1\n");
  EXPECT_EQ(evaluate("(1 | 2 ^ 3 & 2) == 1 && 1 << 3 == 8 && 9 % 4 == 1 && -8 / 2 == -4"), "1\n");
  EXPECT_EQ(evaluate("!0 == 1 && ~0 == -1 && +3 == 3 && - -2 == 2"), "1\n");
  EXPECT_EQ(evaluate("1 ? 0 : 1"), "0\n");
  EXPECT_EQ(evaluate("0x10 == 16 && 010 == 8 && 3u == 3"), "1\n");
  EXPECT_EQ(evaluate("3 <= 2 || 2 >= 3 || 2 != 2"), "0\n");
}

TEST(condition, unknown_names_are_zero) {
  EXPECT_EQ(evaluate("UNKNOWN"), "0\n");
  EXPECT_EQ(evaluate("__VERSION__ == 0 && !GL_ARB_gpu_shader5"), "1\n");
}

TEST(condition, defined_works_with_and_without_parentheses) {
  EXPECT_EQ(evaluate("defined A && defined(A) && !defined B && !defined ( B )", "#define A\n"),
            "1\n");
  EXPECT_EQ(evaluate("defined A", "#define A B\n"), "1\n");
}

TEST(condition, macros_expand_in_conditions) {
  EXPECT_EQ(evaluate("MODE == HIGH && F(2) == 3",
                     "#define HIGH 2\n#define MODE HIGH\n#define F(x) (x + 1)\n"),
            "1\n");
}

TEST(condition, floats_are_cut_to_integers) {
  EXPECT_EQ(evaluate("1.9 == 1 && .5 == 0 && 1e3 == 1000"), "1\n");
}

TEST(condition, operand_that_is_not_needed_may_divide_by_zero) {
  EXPECT_EQ(evaluate("0 && 1 / 0"), "0\n");
  EXPECT_EQ(evaluate("1 || 1 % 0"), "1\n");
  EXPECT_EQ(evaluate("1 ? 2 : 1 / 0"), "1\n");
  EXPECT_EQ(
      evaluate("1 / X"),
      "0\n---\n/a.fsh:1:7: warning: condition of #if: division by zero\n  #if 1 / X\n        ^\n"
      "  hint: Iris goes on after this, other hosts refuse the program\n");
}

TEST(condition, overflow_wraps) {
  EXPECT_EQ(evaluate("9223372036854775807 + 1 < 0"), "1\n");
  EXPECT_EQ(evaluate("(-9223372036854775807 - 1) / -1 < 0"), "1\n");
}

TEST(condition, macro_without_value_counts_as_false_with_a_warning) {
  EXPECT_EQ(evaluate("A", "#define A\n"),
            "0\n---\n"
            "/a.fsh:2:5: warning: the condition 'A' expands to nothing and counts as false\n"
            "  #if A\n"
            "      ^\n"
            "  hint: use #ifdef to ask whether a macro without a value is defined\n");
}

TEST(condition, missing_condition_counts_as_false) {
  EXPECT_EQ(evaluate(""),
            "0\n---\n/a.fsh:1:1: warning: #if without a condition counts as false\n  #if \n  ^\n"
            "  hint: Iris goes on after this, other hosts refuse the program\n");
}

// Iris: JcppProcessor; a missing operand is 0 and the rest still counts.
TEST(condition, malformed_expressions_say_what_was_expected) {
  EXPECT_EQ(evaluate("(1"),
            "0\n---\n/a.fsh:1:6: warning: condition of #if: expected ')'\n  #if (1\n       ^\n"
            "  hint: Iris goes on after this, other hosts refuse the program\n");
  EXPECT_EQ(evaluate("1 +"),
            "1\n---\n/a.fsh:1:7: warning: condition of #if: expected a value at the end of the "
            "expression\n  #if 1 +\n        ^\n"
            "  hint: Iris goes on after this, other hosts refuse the program\n");
  EXPECT_EQ(evaluate("* 2"),
            "0\n---\n/a.fsh:1:5: warning: condition of #if: expected a value, found '*'\n"
            "  #if * 2\n      ^\n"
            "  hint: Iris goes on after this, other hosts refuse the program\n");
  EXPECT_EQ(evaluate("defined(A"),
            "0\n---\n/a.fsh:1:5: warning: expected 'defined NAME' or 'defined(NAME)'\n"
            "  #if defined(A\n      ^\n"
            "  hint: Iris goes on after this, other hosts refuse the program\n");
}

TEST(condition, an_operator_after_ifdef_is_no_remark) {
  EXPECT_EQ(preprocessed("#define A\n#ifdef A || B\nyes\n#endif\n"),
            "yes\n---\n/a.fsh:2:10: warning: text after the end of #ifdef is ignored: '|| B'\n"
            "  #ifdef A || B\n           ^\n"
            "  hint: #ifdef takes one name: write #if with defined(), || between\n");
}

TEST(condition, trailing_text_is_tolerated_with_a_warning) {
  EXPECT_EQ(preprocessed("#define A\n#ifdef A B\nyes\n#endif A\n"),
            "yes\n---\n/a.fsh:2:10: warning: text after the end of #ifdef is ignored: 'B'\n"
            "  #ifdef A B\n           ^\n"
            "  hint: some hosts refuse this; put it into a comment\n");
  EXPECT_EQ(evaluate("1 2"),
            "1\n---\n/a.fsh:1:7: warning: text after the end of #if is ignored: '2'\n"
            "  #if 1 2\n        ^\n"
            "  hint: some hosts refuse this; put it into a comment\n");
}

TEST(condition, nesting_beyond_the_limit_is_an_error) {
  const std::string deep = std::string(5000, '(') + "1" + std::string(5000, ')');
  EXPECT_NE(evaluate(deep).find("condition of #if: expression is nested too deeply"),
            std::string::npos);
  EXPECT_NE(evaluate(std::string(5000, '!') + "1").find("nested too deeply"), std::string::npos);
}

TEST(conditionals, only_the_first_true_branch_is_active) {
  EXPECT_EQ(preprocessed("#if 0\na\n#elif 1\nb\n#elif 1\nc\n#else\nd\n#endif\n"), "b\n");
  EXPECT_EQ(preprocessed("#ifndef X\na\n#else\nb\n#endif\n"), "a\n");
}

TEST(conditionals, inactive_branches_are_not_judged) {
  EXPECT_EQ(preprocessed(
                "#if 0\n#if (\n#elif\n#else garbage\n#endif\n#error x\n#define A 1\n#endif\nA\n"),
            "A\n");
  EXPECT_EQ(preprocessed("#if 1\na\n#elif (\n#endif\n"), "a\n");
}

TEST(conditionals, nested_branches_of_an_inactive_one_stay_inactive) {
  EXPECT_EQ(
      preprocessed(
          "#if 0\n#if 1\na\n#else\nb\n#endif\n  # ifdef X\n# else\nc\n# endif\n#else\nd\n#endif\n"),
      "d\n");
}

TEST(conditionals, of_two_that_are_as_likely_unclosed_both_are_reported) {
  const auto reports = [](const std::string& source, const std::string& message) {
    return preprocessed(source).find(message) != std::string::npos;
  };
  const std::string even = "#if 1\na\n#if 2\nb\n#endif\n";
  EXPECT_TRUE(reports(even, "/a.fsh:1:1: the #if without #endif"));
  EXPECT_TRUE(reports(even, "/a.fsh:2:1: warning: expected #endif after this line"));
  EXPECT_TRUE(reports(even, "note: /a.fsh:3:1: or nothing closes this one instead of line 1"));
  const std::string indented = "#if 1\n  a\n  #if 2\n    b\n#endif\n";
  EXPECT_TRUE(reports(indented, "/a.fsh:3:3: the #if without #endif"));
  EXPECT_FALSE(reports(indented, "or nothing closes"));
}

TEST(conditionals, what_follows_an_else_and_what_it_asks_again_tell_which_is_not_closed) {
  const auto unclosed = [](const std::string& source) {
    const std::string reported = preprocessed(source);
    if (reported.find("or nothing closes") != std::string::npos) return reported;
    return reported.substr(reported.rfind("/a.fsh:", reported.find("the #if without")), 8);
  };
  EXPECT_EQ(unclosed("#if 1\na\n#if 2\nb\n#else\nc\n#else\nd\n#endif\n"), "/a.fsh:3");
  EXPECT_EQ(unclosed("#if 1\na\n#if 1\nb\n#endif\n"), "/a.fsh:1");
}

TEST(conditionals, unbalanced_ones_are_located) {
  // Iris: JcppProcessor logs these and goes on.
  const std::string hint = "  hint: Iris goes on after this, other hosts refuse the program\n";
  EXPECT_EQ(preprocessed("#if 1\na\n"),
            "a\n---\n/a.fsh:2:1: warning: expected #endif after this line: nothing closes the "
            "#if in line 1\n  a\n  ^\n  note: /a.fsh:1:1: the #if without #endif\n" +
                hint);
  EXPECT_EQ(preprocessed("a\n #endif\n"),
            "a\n---\n/a.fsh:2:2: warning: #endif without #if\n   #endif\n   ^\n"
            "  note: /a.fsh:1:1: or an #if is missing before this line\n" +
                hint);
  EXPECT_EQ(preprocessed("#else\n#elif 1\n"),
            "---\n/a.fsh:1:1: warning: #else without #if\n  #else\n  ^\n" + hint +
                "/a.fsh:2:1: warning: #elif without #if\n  #elif 1\n  ^\n" + hint);
  EXPECT_EQ(preprocessed("#if 0\n#else\na\n#else\nb\n#endif\n"),
            "a\n---\n/a.fsh:4:1: warning: #else after #else\n  #else\n  ^\n" + hint);
}

// The place of the #if without #endif or the #endif without #if in /a.fsh with these lines.
std::string partnerless(const std::string& lines, const std::string& included = "") {
  Diagnostics diagnostics;
  preprocess(test::flatten({{"/a.fsh", lines}, {"/b.glsl", included}}, "/a.fsh"), {}, diagnostics);
  const Diagnostic& first = diagnostics.at(0);
  const bool stray = first.message == "#endif without #if";
  return formatLocation(stray ? first.at : first.related.at(0).at) + (stray ? " #endif" : " #if");
}

TEST(conditionals, an_endif_further_left_closes_another_if) {
  EXPECT_EQ(partnerless("#if 1\na\n  #if 1\n  b\nc\n#endif\n"),
            "/a.fsh:3:3 #if");
}

TEST(conditionals, an_endif_further_right_has_no_if) {
  EXPECT_EQ(partnerless("#if 1\na\n  b\n  #endif\nc\n#endif\n"),
            "/a.fsh:4:3 #endif");
}

TEST(conditionals, an_include_guard_ends_with_its_file) {
  EXPECT_EQ(partnerless("#ifndef A\n#define A\n#if 1\na\n\n#endif\n"),
            "/a.fsh:3:1 #if");
  EXPECT_EQ(partnerless("#ifndef A\n#define A\na\n#endif\nb\n#endif\n"),
            "/a.fsh:4:1 #endif");
}

TEST(conditionals, what_an_include_leaves_open_is_its_own) {
  EXPECT_EQ(partnerless("#if 1\n#include \"/b.glsl\"\n#endif\n", "#if 1\na\n"),
            "/b.glsl:1:1 #if");
  EXPECT_EQ(partnerless("#if 1\n#include \"/b.glsl\"\n#endif\n", "a\n#endif\n"),
            "/b.glsl:2:1 #endif");
}

}  // namespace
}  // namespace orris
