// Hostile and random input: no crash, no hang, bounded output.
#include <gtest/gtest.h>

#include <random>

#include <orris/core/limits.h>
#include "glsl/glsl_test.h"
#include <orris/glsl/syntax/stage_size.h>
#include <orris/glsl/syntax/struct_size.h>

namespace orris {
namespace {

struct Outcome {
  std::string text;
  Diagnostics diagnostics;
  std::size_t tokens = 0;
};

Outcome run(const std::string& text) {
  Outcome outcome;
  TokenStream stream = preprocess(test::source(text), {{"ONE", "1"}}, outcome.diagnostics);
  rewrite(stream, Stage::Fragment);
  outcome.tokens = stream.tokens.size();
  outcome.text = print(stream).text;
  preprocessProperties("/p", text, {{"ONE", "1"}}, outcome.diagnostics);
  return outcome;
}

bool reports(const Outcome& outcome, const std::string& id) {
  for (const Diagnostic& d : outcome.diagnostics) {
    if (d.id == id) return true;
  }
  return false;
}

TEST(robustness, random_bytes) {
  std::mt19937 random(1);
  for (int round = 0; round < 300; ++round) {
    std::string text;
    for (int i = 0; i < 400; ++i) text += static_cast<char>(random() % 256);
    run(text);
  }
}

TEST(robustness, random_sequences_of_meaningful_pieces) {
  const std::vector<std::string> pieces = {
      "#if ",     "#ifdef ",   "#elif ",      "#else\n",   "#endif\n", "#define ", "#undef ",
      "F",        "(",         ")",           ",",         "x",        "##",       "#",
      "...",      "\\\n",      "\n",          "\n",        "\n",       "/*",       "*/",
      "//",       "defined",   "ONE",         "1",         "0",        "?",        ":",
      "<",        "&&",        "!",           "/",         "%",        "-",        "{",
      "}",        "[",         "]",           ";",         "=",        "const ",   "float ",
      "uniform ", "texture",   "sample",      "mix",       "shadow2D", "bool ",    "struct ",
      "layout",   "outColor0", "#extension ", "#version ", "\"",       "\t",       " ",
      "F(F(",     "\r\n"};
  std::mt19937 random(2);
  for (int round = 0; round < 3000; ++round) {
    std::string text;
    for (int i = 0; i < 60; ++i) text += pieces[random() % pieces.size()];
    run(text);
  }
}

TEST(robustness, exponential_expansion_is_cut_with_a_diagnostic) {
  std::string text = "#define A0 x\n";
  for (int i = 1; i < 60; ++i) {
    const std::string before = "A" + std::to_string(i - 1);
    text += "#define A" + std::to_string(i) + " " + before + " " + before + "\n";
  }
  const Outcome outcome = run(text + "A59\n");
  EXPECT_TRUE(reports(outcome, "macro-expansion-limit"));
  EXPECT_LT(outcome.tokens, 2'000'000u);
}

TEST(robustness, exponential_arguments_are_cut_with_a_diagnostic) {
  std::string call = "x";
  for (int i = 0; i < 50; ++i) call = "D(" + call + ")";
  const Outcome outcome = run("#define D(x) x x\n" + call + "\n");
  EXPECT_TRUE(reports(outcome, "macro-expansion-limit"));
}

TEST(robustness, nested_strings_are_cut_with_a_diagnostic) {
  std::string text = "#define S(x) #x\n#define E(x) S(x)\n", call = "\"\\\"";
  for (int i = 0; i < 28; ++i) call = "E(" + call + ")";
  const Outcome outcome = run(text + call + "\n");
  EXPECT_TRUE(reports(outcome, "macro-expansion-limit"));
  EXPECT_LT(outcome.text.size(), 1'000'000u);
}

TEST(robustness, pasted_tokens_are_cut_with_a_diagnostic) {
  std::string text = "#define P(a, b) P2(a, b)\n#define P2(a, b) a ## b\n#define A0 xxxxxxxx\n";
  for (int i = 1; i < 40; ++i) {
    const std::string before = "A" + std::to_string(i - 1);
    text += "#define A" + std::to_string(i) + " P(" + before + ", " + before + ")\n";
  }
  const Outcome outcome = run(text + "A39\n");
  EXPECT_TRUE(reports(outcome, "macro-expansion-limit"));
  EXPECT_LT(outcome.text.size(), 1'000'000u);
}

TEST(robustness, a_long_string_given_often_is_cut_with_a_diagnostic) {
  std::string text = "#define S(x) #x\n#define R(x)";
  for (int i = 0; i < 2000; ++i) text += " x";
  EXPECT_TRUE(
      reports(run(text + "\nR(S(" + std::string(60'000, 'a') + "))\n"), "macro-expansion-limit"));
}

TEST(robustness, what_does_not_fit_one_expansion_is_reported) {
  std::string text = "#define R(x)", arguments;
  for (int i = 0; i < 1000; ++i) text += " x";
  for (int i = 0; i < 1000; ++i) arguments += "a ";
  EXPECT_TRUE(reports(run(text + "\nR(" + arguments + ")\n"), "macro-expansion-limit"));
}

TEST(robustness, structs_that_double_are_reported_at_the_first_that_is_too_large) {
  const auto found = [](int levels) {
    std::string text = "struct S0 { float a[2], b; };\n";
    for (int i = 1; i <= levels; ++i) {
      const std::string name = "S" + std::to_string(i), inner = "S" + std::to_string(i - 1);
      text += "struct /* one */ " + name + " { highp " + inner + " a, b[3]; };\n";
    }
    Diagnostics diagnostics;
    checkStructSizes(preprocess(test::source(text), {}, diagnostics), diagnostics);
    return diagnostics;
  };
  EXPECT_TRUE(found(15).empty());  // 65536 members
  const Diagnostics diagnostics = found(30);
  ASSERT_EQ(diagnostics.size(), 1u);
  EXPECT_EQ(diagnostics[0].id, "struct-too-large");
  EXPECT_EQ(diagnostics[0].at.line, 17);
  EXPECT_EQ(diagnostics[0].at.column, 18);
}

Diagnostics stageSizesOf(const std::string& text) {
  Diagnostics diagnostics;
  checkStageSize(preprocess(test::source(text), {}, diagnostics), diagnostics);
  return diagnostics;
}

TEST(robustness, functions_that_double_are_reported_where_main_reaches_them) {
  const auto text = [](int levels, const std::string& called) {
    std::string functions = "float f0(float x) { return sin(x); }\nfloat f0(vec2 v) { return f0(v.x) + f0(v.y); }\n";
    for (int i = 1; i <= levels; ++i) {
      const std::string inner = "f" + std::to_string(i - 1);
      functions += "float f" + std::to_string(i) + "(float x) { return " + inner + "(x) /* and */ + " + inner + "(x + 1.0); }\n";
    }
    return "float " + called + "(float);\nvoid main() { gl_FragColor = vec4(" + called + "(1.0)); }\n" + functions;
  };
  EXPECT_TRUE(stageSizesOf(text(16, "f13")).empty());
  EXPECT_TRUE(stageSizesOf(text(30, "f13")).empty());  // the others are of no use
  const Diagnostics diagnostics = stageSizesOf(text(30, "f30"));
  ASSERT_EQ(diagnostics.size(), 1u);
  EXPECT_EQ(diagnostics[0].id, "stage-too-large");
  EXPECT_EQ(diagnostics[0].at.line, 18);
  EXPECT_EQ(diagnostics[0].at.column, 7);
}

TEST(robustness, functions_that_call_each_other_in_long_chains_or_circles_are_counted_once) {
  std::string chain = "float f0() { return f1(); }\n";
  for (int i = 1; i < 20'000; ++i)
    chain += "float f" + std::to_string(i) + "() { return f" + std::to_string(i - 1) + "(); }\n";
  EXPECT_TRUE(stageSizesOf(chain + "void main() { f19999(); }\n").empty());
}

TEST(robustness, arrays_of_too_many_elements_are_reported) {
  const auto reported = [](const std::string& text) {
    const Diagnostics diagnostics = stageSizesOf(text);
    for (const Diagnostic& d : diagnostics) EXPECT_EQ(d.id, "stage-too-large");
    return diagnostics.size();
  };
  const std::string inMain = "void main() {\n";
  EXPECT_EQ(reported(inMain + "float a[8192]; a[100000] = 1.0; }"), 0u);
  EXPECT_EQ(reported(inMain + "float a[8193]; }"), 1u);
  EXPECT_EQ(reported(inMain + "float a = f(b, c[100000]), d[8193]; }"), 1u);
  EXPECT_EQ(reported(inMain + "return values[100000]; }"), 0u);
  EXPECT_EQ(reported(inMain + "float[1000][1000] a; }"), 1u);
  EXPECT_EQ(reported("const int N = 1 << 9;\nconst int M = 2 * N;\nuniform vec4 u[N][M];\n"), 1u);
  EXPECT_EQ(reported("const int N = 1 << 9;\nuniform vec4 u[N][unknown];\n"), 0u);
  EXPECT_EQ(reported("float f(float x, const float a[100000]) { return a[0]; }\n"), 1u);
  EXPECT_EQ(reported("layout(std430) buffer B { uint n[100000]; } b;\nshared uint s[100000];\n"), 0u);
  EXPECT_EQ(reported("struct S { float a[100000]; };\nuniform U { float a[100000]; };\n"), 1u);
  EXPECT_EQ(reported("struct S { float a[100000]; };\nout S s;\n"), 0u);
}

TEST(robustness, switches_of_too_many_cases_are_reported) {
  const auto text = [](std::size_t count) {
    std::string cases;
    for (std::size_t i = 0; i < count; ++i) cases += "case " + std::to_string(i) + ": x = 1.0; break;\n";
    return "void main() {\nswitch (int(y)) {\n" + cases + "}\n}\n";
  };
  EXPECT_TRUE(stageSizesOf(text(limits::kSwitchCases)).empty());
  const Diagnostics diagnostics = stageSizesOf(text(limits::kSwitchCases + 1));
  ASSERT_EQ(diagnostics.size(), 1u);
  EXPECT_EQ(diagnostics[0].at.line, 2);
}

TEST(robustness, a_source_of_too_many_bytes_is_cut_unless_a_branch_is_inactive) {
  std::string comments;
  for (std::size_t i = 0; i <= limits::kStageReadBytes / 4096; ++i)
    comments += "// " + std::string(4096, 'x') + "\n";
  EXPECT_TRUE(reports(run("#if 1\n" + comments + "#endif\n"), "source-too-large"));
  EXPECT_TRUE(reports(run("/* " + comments + "*/\n"), "source-too-large"));
  EXPECT_FALSE(reports(run("#if 0\n" + comments + "#endif\n"), "source-too-large"));
}

TEST(robustness, a_source_of_too_many_tokens_is_cut_with_a_diagnostic) {
  std::string line;
  for (std::size_t i = 0; i < limits::kStageTokens / 100; ++i) line += "a ";
  std::string text = "#if 1\n";
  for (int i = 0; i < 99; ++i) text += line + "\n";
  EXPECT_FALSE(reports(run(text + "#endif\n"), "source-too-large"));
  Diagnostics diagnostics;
  const TokenStream stream =
      preprocess(test::source(text + line + "a b c\n#endif\n"), {}, diagnostics);
  ASSERT_EQ(diagnostics.size(), 1u) << "nothing follows from what was cut off";
  EXPECT_EQ(formatDiagnostic(diagnostics[0]).substr(0, 13), "/a.fsh:101:79");
  EXPECT_LE(stream.tokens.size(), limits::kStageTokens);
}

TEST(robustness, deep_argument_nesting_is_cut_with_a_diagnostic) {
  std::string call = "x";
  for (int i = 0; i < 5000; ++i) call = "I(" + call + ")";
  EXPECT_TRUE(reports(run("#define I(x) x\n" + call + "\n"), "macro-expansion-limit"));
}

TEST(robustness, long_chains_of_macros_end) {
  std::string text = "#define A0 x\n";
  for (int i = 1; i < 20000; ++i) {
    text += "#define A" + std::to_string(i) + " A" + std::to_string(i - 1) + "\n";
  }
  EXPECT_TRUE(reports(run(text + "A19999\n"), "macro-expansion-limit"));
}

TEST(robustness, deep_brackets_and_conditionals_do_not_exhaust_the_stack) {
  run(std::string(100000, '(') + std::string(100000, '{'));
  std::string nested;
  for (int i = 0; i < 20000; ++i) nested += "#if 1\n";
  const Outcome outcome = run(nested);
  EXPECT_TRUE(reports(outcome, "conditional-unbalanced"));
  EXPECT_LE(outcome.diagnostics.size(), 300u);
}

TEST(robustness, many_comments_and_continuations_take_linear_time) {
  std::string text;
  for (int i = 0; i < 20000; ++i) text += "/* a\n */ b /*\n*/ \\\n";
  run(text);
  run(std::string(200000, '\\') + "\n");
  std::string continued;
  for (int i = 0; i < 100000; ++i) continued += "a \\\n";
  run(continued);
}

}  // namespace
}  // namespace orris
