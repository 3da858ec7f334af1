#include <orris/glsl/preprocess/preprocessor.h>

#include <gtest/gtest.h>

#include "glsl/glsl_test.h"

namespace orris {
namespace {

using test::preprocessed;

// Iris: JcppProcessor appends the text of each token, so expansions run together.
TEST(preprocessor, expansions_run_together_with_what_follows) {
  EXPECT_EQ(preprocessed("#define N 16\nx = N.0 + (N.5) - N .5;\n"),
            "x = 16.0 + (16.5) - 16 .5;\n");
  EXPECT_EQ(preprocessed("#define M -1\nx = 2-M;\n"), "x = 2--1;\n");
  EXPECT_EQ(preprocessed("#define N 1\n#define D .5\nN D; a.b;\n"), "1 .5; a.b;\n");
  EXPECT_EQ(preprocessed("a/**/b\n"), "a b\n");
}

TEST(preprocessor, object_macro_expands_and_its_lines_vanish) {
  EXPECT_EQ(preprocessed("#define N 3\nint a = N;\n"), "int a = 3;\n");
}

TEST(preprocessor, macro_is_unknown_before_its_definition) {
  EXPECT_EQ(preprocessed("int a = N;\n#define N 3\nint b = N;\n"), "int a = N;\n\nint b = 3;\n");
}

TEST(preprocessor, redefinition_silently_replaces) {
  EXPECT_EQ(preprocessed("#define N 3\n#define N 4\nN\n"), "4\n");
  EXPECT_EQ(preprocessed("#define N 3\n#define N(x) x\nN(5) N\n"), "5 N\n");
}

TEST(preprocessor, undef_removes_and_of_an_unknown_name_is_harmless) {
  EXPECT_EQ(preprocessed("#define N 3\n#undef N\n#undef M\nN\n"), "N\n");
}

TEST(preprocessor, environment_macros_are_known_on_the_first_line) {
  EXPECT_EQ(
      preprocessed("#if MC_VERSION >= 11300\nnew\n#else\nold\n#endif\n", {{"MC_VERSION", "12101"}}),
      "new\n");
  EXPECT_EQ(preprocessed("a IS_IRIS b\n", {{"IS_IRIS", ""}}), "a b\n");
}

TEST(preprocessor, function_macro_takes_arguments_over_several_lines) {
  EXPECT_EQ(preprocessed(
                "#define MAD(a, b, c) ((a) * (b) + (c))\nfloat x = MAD(1.0,\n  f(2, 3),\n  c);\n"),
            "float x = ((1.0) * (\nf(2, 3)) + (\nc));\n");
}

TEST(preprocessor, function_macro_without_parenthesis_stays) {
  EXPECT_EQ(preprocessed("#define F(x) x\nF + F /* c */ (2);\nF\n"), "F + 2;\nF\n");
}

TEST(preprocessor, empty_and_missing_arguments) {
  EXPECT_EQ(preprocessed("#define F(x) [x]\n#define G() g\nF() G()\n"), "[] g\n");
  EXPECT_EQ(preprocessed("#define F(x, y) x\nF(1);\n"),
            "F;\n---\n"
            "/a.fsh:2:1: error: macro 'F' takes 2 arguments, given 1\n  F(1);\n  ^\n");
}

TEST(preprocessor, unclosed_invocation_is_reported_where_it_starts) {
  EXPECT_EQ(preprocessed("#define F(x) x\n  F(1;\n"),
            "  F\n---\n"
            "/a.fsh:2:3: error: invocation of macro 'F' is not closed: expected ')'\n"
            "    F(1;\n    ^\n");
}

TEST(preprocessor, arguments_expand_before_the_body_is_read_again) {
  EXPECT_EQ(preprocessed("#define A B\n#define B 1\n#define F(x) x + A\nF(A)\n"), "1 + 1\n");
  EXPECT_EQ(preprocessed("#define F(x) x*2\n#define G F\nG(F(3))\n"), "3*2*2\n");
}

TEST(preprocessor, a_macro_does_not_expand_inside_itself) {
  EXPECT_EQ(preprocessed("#define A A + 1\nA\n"), "A + 1\n");
  EXPECT_EQ(preprocessed("#define A B\n#define B A\nA B\n"), "A B\n");
  EXPECT_EQ(preprocessed("#define f(x) f(x + 1)\nf(f(2))\n"), "f(f(2 + 1) + 1)\n");
}

TEST(preprocessor, paste_and_stringify) {
  EXPECT_EQ(preprocessed("#define CAT(a, b) a##b\nint CAT(fo, o) = CAT(1, 2);\n"),
            "int foo = 12;\n");
  EXPECT_EQ(preprocessed("#define CAT(a, b) a ## b\n#define N 7\nCAT(N, ) CAT(, N) CAT(N, N)\n"),
            "7 7 NN\n");
  EXPECT_EQ(preprocessed("#define S(x) #x\nS(a  + \"b\")\n"), "\"a + \\\"b\\\"\"\n");
  EXPECT_EQ(preprocessed("#define COLOR(i) colortex##i\nCOLOR(4)\n"), "colortex4\n");
}

TEST(preprocessor, variadic_macro_keeps_commas) {
  EXPECT_EQ(preprocessed("#define V(a, ...) f(a, __VA_ARGS__)\nV(1, 2, 3)\n"), "f(1, 2, 3)\n");
}

TEST(preprocessor, continuation_joins_lines_everywhere) {
  EXPECT_EQ(
      preprocessed("#define A 1 + \\\n  2\nint a \\\n = A;\n// c \\\nstill comment\nint b;\n"),
      "int a = 1 + 2;\nint b;\n");
  EXPECT_EQ(preprocessed("#define A 1 + \\\r\n  2\r\nA\r\n"), "1 + 2\n");
}

TEST(preprocessor, nul_bytes_and_byte_order_mark_vanish) {
  using namespace std::string_literals;
  EXPECT_EQ(preprocessed("\xEF\xBB\xBF#define A 1\nin\0t a = A;\0\n"s), "int a = 1;\n");
}

TEST(preprocessor, comments_stay_as_tokens_and_print_as_white_space) {
  Diagnostics diagnostics;
  const TokenStream stream =
      preprocess(test::source("/* DRAWBUFFERS:01 */ a/* x */b // end\n#if 0\n/* DRAWBUFFERS:2 "
                              "*/\n#endif\n/* two\nlines */ c\n"),
                 {}, diagnostics);
  std::vector<std::string> comments;
  for (const Token& token : stream.tokens) {
    if (token.kind == TokenKind::Comment) comments.push_back(token.text);
  }
  EXPECT_EQ(comments, (std::vector<std::string>{"/* DRAWBUFFERS:01 */", "/* x */", "// end",
                                                "/* two\nlines */"}));
  EXPECT_EQ(print(stream).text, "                     a b\n\n         c\n");
}

TEST(preprocessor, comments_inside_directives_count_as_blanks) {
  EXPECT_EQ(
      preprocessed(
          "#define A /* one\n two */ 1 // three\n#/**/if/**/A/**/==/**/1\nyes A\n#endif // A\n"),
      "yes 1\n");
}

TEST(preprocessor, directives_inside_block_comments_do_not_run) {
  EXPECT_EQ(preprocessed("/*\n#define A 1\n*/\nA\n#if 0\n/*\n#endif\n*/\nno\n#endif\nyes\n"),
            "A\n\nyes\n");
}

TEST(preprocessor, unclosed_comment_is_reported_where_it_opens) {
  EXPECT_EQ(preprocessed("a\n  /* b\nc\n"),
            "a\n---\n/a.fsh:2:3: error: block comment is not closed: expected */ before the end\n"
            "    /* b\n    ^\n");
}

TEST(preprocessor, version_and_extensions_of_active_branches_are_collected) {
  Diagnostics diagnostics;
  const TokenStream stream = preprocess(
      test::source("int a;\n#if 1\n#extension GL_A : require\n#else\n#extension GL_B : enable\n"
                   "#endif\n  #version 130 compatibility\n#extension GL_C : enable // c\n"),
      {}, diagnostics);
  EXPECT_EQ(test::format(diagnostics), "");
  EXPECT_EQ(
      print(stream).text,
      "#version 130 compatibility\n#extension GL_A : require\n#extension GL_C : enable\nint a;\n");
  EXPECT_EQ(stream.version, 130);
  EXPECT_EQ(stream.profile, "compatibility");
  EXPECT_EQ(stream.versionOrigin.line, 7);
  EXPECT_EQ(print(stream).locate(2, 1), (SourceLocation{"/a.fsh", 3, 1}));
}

TEST(preprocessor, a_second_version_is_an_error) {
  EXPECT_EQ(preprocessed("#version 120\n#version 330\n"),
            "#version 120\n---\n"
            "/a.fsh:2:1: error: a second active #version; exactly one is allowed; Iris refuses the whole pack\n"
            "  #version 330\n  ^\n");
}

// Iris's parser (glsl-transformer) knows no other numbers and profiles.
TEST(preprocessor, a_version_is_one_of_glsl) {
  const std::string hint =
      "  hint: write '#version 330 compatibility', or one of 110, 120, 130, 140, 150, 330, 400, 410, 420, 430, 440, 450, 460, "
      "100, 300, 310, 320\n";
  for (const std::string number : {"16", "4096", "2.5", "0x14a", "abc"}) {
    EXPECT_EQ(preprocessed("#version " + number + "\n"),
              "---\n/a.fsh:1:1: error: GLSL has no version " + number + "; Iris refuses the whole pack\n  #version " + number + "\n  ^\n" + hint);
  }
  EXPECT_EQ(preprocessed("#version\n"),
            "---\n/a.fsh:1:1: error: expected a version of GLSL after #version; Iris refuses the whole pack\n  #version\n  ^\n" + hint);
  EXPECT_EQ(preprocessed("#version 310 es\n"), "#version 310 es\n");
}

TEST(preprocessor, a_version_has_a_profile_and_nothing_else) {
  EXPECT_EQ(preprocessed("#version 330 compatability\n"),
            "#version 330\n---\n/a.fsh:1:14: error: expected 'core' or 'compatibility' after #version 330, found "
            "'compatability'; Iris refuses the whole pack\n  #version 330 compatability\n               ^\n");
  EXPECT_EQ(preprocessed("#version 450 core 1\n"),
            "#version 450 core\n---\n/a.fsh:1:19: error: expected the end of the line after '#version 450 core', found "
            "'1'; Iris refuses the whole pack\n  #version 450 core 1\n                    ^\n");
}

TEST(preprocessor, a_malformed_version_is_not_missing_as_well) {
  Diagnostics diagnostics;
  const TokenStream stream = preprocess(test::source("#version 16\n"), {}, diagnostics);
  requireVersion(stream, diagnostics);
  ASSERT_EQ(diagnostics.size(), 1u);
  EXPECT_EQ(diagnostics[0].id, "version-malformed");
}

TEST(preprocessor, a_source_without_active_version_is_an_error) {
  Diagnostics diagnostics;
  const TokenStream stream =
      preprocess(test::source("// a\n#if 0\n#version 120\n#endif\n"), {}, diagnostics);
  EXPECT_EQ(stream.version, 0);
  EXPECT_TRUE(diagnostics.empty());
  requireVersion(stream, diagnostics);
  EXPECT_EQ(test::format(diagnostics),
            "/a.fsh:1: error: no active #version; exactly one is required\n"
            "  hint: begin the file with '#version 330 compatibility'\n");
}

TEST(preprocessor, line_pragma_and_null_directives_are_dropped) {
  EXPECT_EQ(preprocessed("#line 7\n#pragma optimize(on)\n#\n# 3 \"x\"\na __LINE__\n"),
            "a __LINE__\n");
}

TEST(preprocessor, error_directive_of_an_active_branch_is_reported_verbatim) {
  EXPECT_EQ(preprocessed("#ifdef A\n#error no\n#else\n#error don't  do this\n#endif\n#warning w\n"),
            "---\n/a.fsh:4:1: error: #error don't do this\n  #error don't  do this\n  ^\n"
            "/a.fsh:6:1: warning: #warning w\n  #warning w\n  ^\n");
}

TEST(preprocessor, malformed_directives_are_reported_and_the_rest_goes_on) {
  EXPECT_EQ(preprocessed("#define 1x\n"),
            "---\n/a.fsh:1:1: warning: '1x' cannot be the name of a macro\n  #define 1x\n  ^\n"
            "  hint: Iris goes on after this, other hosts refuse the program\n");
  EXPECT_EQ(preprocessed("#define F(a\nb\n"),
            "b\n---\n/a.fsh:1:1: warning: parameter list of macro 'F' is not closed\n"
            "  #define F(a\n  ^\n"
            "  hint: Iris goes on after this, other hosts refuse the program\n");
  EXPECT_EQ(preprocessed("#extension GL_A\n"),
            "---\n/a.fsh:1:1: error: expected '#extension NAME : enable', 'require', 'warn' or "
            "'disable'; Iris refuses the program\n  #extension GL_A\n  ^\n");
  EXPECT_EQ(preprocessed("#extension GL_A enable\n"),
            "---\n/a.fsh:1:1: error: expected '#extension NAME : enable', 'require', 'warn' or "
            "'disable'; Iris refuses the whole pack\n  #extension GL_A enable\n  ^\n");
  EXPECT_EQ(preprocessed("#frob\n#if 0\n#frob\n#endif\n"),
            "---\n/a.fsh:1:1: warning: unknown preprocessor directive '#frob'\n  #frob\n  ^\n"
            "  hint: Iris goes on after this, other hosts refuse the program\n");
}

}  // namespace
}  // namespace orris
