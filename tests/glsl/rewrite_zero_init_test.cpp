#include <gtest/gtest.h>

#include "glsl/glsl_test.h"

namespace orris {
namespace {

using test::rewritten;

// How the rule firedAt: "count@line:column" of the first place, or "".
std::string firedAt(const std::string& text, Stage stage = Stage::Fragment) {
  RewriteResult result;
  rewritten(text, stage, &result);
  for (const AppliedRule& rule : result.rules) {
    if (rule.rule != "zero-init") continue;
    return std::to_string(rule.count) + "@" + std::to_string(rule.first.line) + ":" +
           std::to_string(rule.first.column);
  }
  return "";
}

// A statement of main() after rewriting.
std::string inMain(const std::string& statement) {
  const std::string text = rewritten("void main() { " + statement + " }\n");
  return text.substr(14, text.rfind(" }") - 14);
}

std::string glslangVerdict(const std::string& text) {
  Diagnostics diagnostics;
  TokenStream stream = preprocess(test::source(text), {}, diagnostics);
  rewrite(stream, Stage::Fragment);
  const StageText stage{Stage::Fragment, print(stream)};
  validateWithGlslang({&stage}, test::linesOf({{"/a.fsh", text}}), diagnostics);
  return test::format(diagnostics);
}

TEST(zero_init, each_declarator_without_a_value_gets_one) {
  EXPECT_EQ(inMain("vec3 a, b = x, c;"), "vec3 a = vec3(0), b = x, c = vec3(0);");
  EXPECT_EQ(inMain("float a = f(x, y), b;"), "float a = f(x, y), b = 0.0;");
  EXPECT_EQ(firedAt("void main() {\n  vec3 a, b = x, c;\n  int d; }\n"), "3@2:8");
}

TEST(zero_init, every_basic_type_has_its_zero) {
  EXPECT_EQ(inMain("float x; int i; uint u; bool b;"),
            "float x = 0.0; int i = 0; uint u = 0u; bool b = false;");
  EXPECT_EQ(inMain("ivec2 a; uvec3 b; bvec4 c; vec4 d;"),
            "ivec2 a = ivec2(0); uvec3 b = uvec3(0); bvec4 c = bvec4(0); vec4 d = vec4(0);");
  EXPECT_EQ(inMain("mat3 a; mat4x2 b;"), "mat3 a = mat3(0); mat4x2 b = mat4x2(0);");
  EXPECT_EQ(inMain("sampler2D a; S b;"), "sampler2D a; S b;");
}

TEST(zero_init, a_declaration_may_start_any_statement) {
  EXPECT_EQ(inMain("if (c) float x; else float y;"), "if (c) float x = 0.0; else float y = 0.0;");
  EXPECT_EQ(inMain("for (;;) { float x; }"), "for (;;) { float x = 0.0; }");
  EXPECT_EQ(inMain("switch (i) { case 0: int x; break; }"),
            "switch (i) { case 0: int x = 0; break; }");
  EXPECT_EQ(inMain("do float x; while (c);"), "do float x = 0.0; while (c);");
  EXPECT_EQ(inMain("highp float x; /* y */ mediump vec2 z;"),
            "highp float x = 0.0; mediump vec2 z = vec2(0);");
}

TEST(zero_init, applies_to_plain_globals_of_every_stage) {
  for (Stage stage : {Stage::Vertex, Stage::TessControl, Stage::TessEvaluation, Stage::Geometry,
                      Stage::Fragment, Stage::Compute}) {
    EXPECT_EQ(firedAt("highp vec3 a;\nfloat b = 1.0, c;\n", stage), "2@1:12") << stageName(stage);
  }
  EXPECT_EQ(rewritten("mediump vec3 a;\n"), "mediump vec3 a = vec3(0);\n");
}

TEST(zero_init, qualified_globals_stay) {
  EXPECT_EQ(firedAt("in vec3 a;\nout vec4 b;\nuniform float c;\nconst float d = 1.0;\n"
                    "layout(location = 0) out vec4 e;\nflat in int f;\ninvariant out vec3 g;\n"
                    "precise float h;\nprecision highp float;\n"),
            "");
  EXPECT_EQ(firedAt("attribute vec4 a;\nvarying vec2 b;\nuniform vec4 c[4], d;\n", Stage::Vertex),
            "");
  EXPECT_EQ(
      firedAt("#version 430\nlayout(local_size_x = 8) in;\nshared float a;\nshared uint b[64];\n"
              "buffer B { uint c; };\n",
              Stage::Compute),
      "");
  EXPECT_EQ(firedAt("float gl_ClipDistance[1];\n", Stage::Vertex), "");
}

TEST(zero_init, members_parameters_and_prototypes_stay) {
  EXPECT_EQ(firedAt("struct S { float a; vec3 b, c; };\n"), "");
  EXPECT_EQ(firedAt("uniform U { float a; vec3 b; } u;\nlayout(std430) buffer B { int c[]; };\n"),
            "");
  EXPECT_EQ(firedAt("void main() { struct S { float a; vec3 b; }; }\n"), "");
  EXPECT_EQ(firedAt("float f(vec3);\nvec3 g(float a, out vec3 b);\n"), "");
  EXPECT_EQ(
      firedAt("float f(vec3 a, inout float b, out int c) { return b; }\nfloat x = f(a, b, c);\n"),
      "");
}

TEST(zero_init, headers_of_loops_and_constants_of_functions_stay) {
  EXPECT_EQ(firedAt("void main() { for (int i = 0, j; i < 4; ++i) {} for (float x; ;) {} }\n"), "");
  EXPECT_EQ(firedAt("void main() { const float a = 1.0; while (bool b = c) {} }\n"), "");
  EXPECT_EQ(
      firedAt("void main() { x = c ? float(y) : vec3(z).x; float(1); precision highp int; }\n"),
      "");
}

TEST(zero_init, small_arrays_of_a_literal_size_are_cleared) {
  EXPECT_EQ(inMain("float a[2], b;"), "float a[2] = float[2](0.0, 0.0), b = 0.0;");
  EXPECT_EQ(inMain("ivec2[2] a;"), "ivec2[2] a = ivec2[2](ivec2(0), ivec2(0));");
  EXPECT_NE(firedAt("float a[16];\n"), "");
  for (const char* text : {"float a[17];\n", "float a[N];\n", "float a[];\n", "float a[0];\n",
                           "float a[2][2];\n", "float[2] a[2];\n", "float a[2] = b;\n"}) {
    EXPECT_EQ(firedAt(text), "") << text;
  }
}

TEST(zero_init, structs_of_known_members_are_cleared) {
  const std::string ray = "struct Ray { vec3 at; float t[2], u; };\n";
  EXPECT_EQ(
      rewritten(ray + "struct Hit { Ray ray; bool any; };\nvoid main() { Hit a; Ray b = r; }\n"),
      ray +
          "struct Hit { Ray ray; bool any; };\n"
          "void main() { Hit a = Hit(Ray(vec3(0), float[2](0.0, 0.0), 0.0), false); "
          "Ray b = r; }\n");
}

TEST(zero_init, structs_with_other_members_and_local_ones_stay) {
  EXPECT_EQ(firedAt("struct S { float a[N]; };\nvoid main() { S s; }\n"), "");
  EXPECT_EQ(firedAt("struct S { sampler2D a; };\nvoid main() { S s; }\n"), "");
  EXPECT_EQ(firedAt("struct S { float a; };\nvoid main() { struct S { int b; int c; }; S s; }\n"),
            "");
  EXPECT_EQ(firedAt("void main() { T t; }\n"), "");
}

TEST(zero_init, nested_structs_do_not_grow_without_bound) {
  std::string text = "struct S0 { float a[16]; };\n";
  for (int i = 1; i < 40; ++i) {
    text += "struct S" + std::to_string(i) + " { S" + std::to_string(i - 1) + " a[16]; };\n";
  }
  EXPECT_LT(rewritten(text + "void main() { S39 s; S1 t; }\n").size(), text.size() + 5000);
}

TEST(zero_init, many_large_declarations_are_bounded) {
  std::string text = "struct S { mat4 a[16]; };\nvoid main() {";
  for (int i = 0; i < 50000; ++i) text += "S s;";
  EXPECT_LT(rewritten(text + "}\n").size(), text.size() + 1'200'000);
}

TEST(zero_init, the_result_is_accepted_by_glslang) {
  EXPECT_EQ(
      glslangVerdict("#version 130\nstruct P { mat2x3 m; bvec2 b; uint u[3]; };\n"
                     "struct Q { P p[2]; ivec4 i; };\nmat3 g;\nbool[2] h;\nout vec4 color;\n"
                     "void main() {\n  Q q; vec3 sum; mat4 m; uvec2 u; bvec3 b; int i; bool c;\n"
                     "  sum += vec3(q.i.xyz) + g[0] + m[0].xyz + vec3(u, i);\n"
                     "  if (c || b.x || h[1]) sum += q.p[1].m[0];\n"
                     "  switch (i) { case 0: float x; sum += x; break; }\n"
                     "  color = vec4(sum, 1.0);\n}\n"),
      "");
}

TEST(zero_init, columns_map_to_the_author_s_text) {
  Diagnostics diagnostics;
  TokenStream stream =
      preprocess(test::source("void main() {\n  vec3 a, bb;\n  a = bb;\n}\n"), {}, diagnostics);
  rewrite(stream, Stage::Fragment);
  const MappedText text = print(stream);
  const std::string line = "  vec3 a = vec3(0), bb = vec3(0);";
  ASSERT_EQ(text.text, "#version 450 compatibility\nvoid main() {\n" + line + "\n  a = bb;\n}\n");
  const auto columnOf = [&](const std::string& word) {
    return text.locate(3, static_cast<int>(line.find(word)) + 1);
  };
  EXPECT_EQ(columnOf("a ="), (SourceLocation{"/a.fsh", 2, 8}));
  EXPECT_EQ(columnOf("(0), bb"), (SourceLocation{"/a.fsh", 2, 8}));
  EXPECT_EQ(columnOf(", bb"), (SourceLocation{"/a.fsh", 2, 9}));
  EXPECT_EQ(columnOf("bb"), (SourceLocation{"/a.fsh", 2, 11}));
  EXPECT_EQ(columnOf("(0);"), (SourceLocation{"/a.fsh", 2, 11}));
  EXPECT_EQ(columnOf(";"), (SourceLocation{"/a.fsh", 2, 13}));
  EXPECT_EQ(text.locate(4, 7), (SourceLocation{"/a.fsh", 3, 7}));
}

}  // namespace
}  // namespace orris
