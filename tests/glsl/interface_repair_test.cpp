#include <orris/glsl/rewrite/interface_repair.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "glsl/glsl_test.h"
#include <orris/glsl/tokens/file_scope.h>
#include <orris/glsl/tokens/text_edits.h>

namespace orris {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

StageText stageOf(Stage stage, const std::string& text) {
  Diagnostics diagnostics;
  const std::string file = std::string("/a.") + stageExtension(stage);
  TokenStream stream = preprocess(test::flatten({{file, text}}, file), {}, diagnostics);
  rewrite(stream, stage);
  return {stage, print(stream)};
}

std::optional<RepairedInterface> repaired(const std::string& vertex, const std::string& fragment) {
  const StageText from = stageOf(Stage::Vertex, vertex), to = stageOf(Stage::Fragment, fragment);
  return repairInterface({&from, &to});
}

/// What glslang says about the two stages, repaired.
std::string verdict(const std::string& vertex, const std::string& fragment) {
  Diagnostics diagnostics;
  const StageText from = stageOf(Stage::Vertex, vertex), to = stageOf(Stage::Fragment, fragment);
  validateWithGlslang(
      {&from, &to}, [](const std::string&, int) { return ""; }, diagnostics);
  return test::format(diagnostics);
}

const std::string kHead = "#version 330 compatibility\n";
const std::string kVertex = kHead + "void main() {\n  gl_Position = ftransform();\n}\n";

std::string reading(const std::string& declaration, const std::string& expression) {
  return kHead + declaration + "\nvoid main() {\n  gl_FragColor = vec4(" + expression + ");\n}\n";
}

TEST(interfaceRepair, an_input_nobody_writes_is_declared_as_zero_in_the_stage_before) {
  const std::string fragment = reading("flat in vec3 tint;", "tint, 1.0");
  const auto result = repaired(kVertex, fragment);
  ASSERT_TRUE(result);
  EXPECT_THAT(result->names, ElementsAre("tint"));
  EXPECT_EQ(result->stages[0].text.text,
            "#version 450 compatibility\nflat out vec3 tint; void main() { tint = vec3(0);\n"
            "  gl_Position = ftransform();\n}\n");
  EXPECT_EQ(verdict(kVertex, fragment), "");
}

TEST(interfaceRepair, an_input_that_is_not_used_is_left_alone) {
  EXPECT_FALSE(
      repaired(kVertex, kHead + "in vec3 tint;\nvoid main() { gl_FragColor = vec4(1); }\n"));
}

TEST(interfaceRepair, an_output_that_is_only_declared_is_zero) {
  const auto result =
      repaired(kHead + "out vec2 uv;\nvoid main() { gl_Position = ftransform(); }\n",
               reading("in vec2 uv;", "uv, 0.0, 1.0"));
  ASSERT_TRUE(result);
  EXPECT_THAT(result->stages[0].text.text, HasSubstr("void main() { uv = vec2(0);"));
}

TEST(interfaceRepair, values_of_another_type_of_their_kind_are_converted) {
  struct Row {
    std::string out, in, use, value;
  };
  const Row rows[] = {{"vec2", "vec4", "x", "vec4(orris_x, vec4(0))"},
                      {"vec4", "vec2", "x, 0.0, 1.0", "vec2(orris_x)"},
                      {"int", "float", "x", "float(orris_x)"},
                      {"mat3", "mat4x3", "x[0], 1.0", "mat4x3(orris_x)"}};
  for (const Row& row : rows) {
    const std::string vertex = kHead + "out " + row.out +
                               " x, y;\nvoid main() {\n  x = " + row.out +
                               "(1); y = x;\n  gl_Position = ftransform();\n}\n";
    const std::string fragment = reading("in " + row.in + " x;", row.use);
    const auto result = repaired(vertex, fragment);
    ASSERT_TRUE(result) << row.out;
    EXPECT_EQ(result->stages[0].text.text,
              "#version 450 compatibility\nout " + row.in + " x; out " + row.out +
                  " orris_x, y;\nvoid main() {\n  orris_x = " + row.out +
                  "(1); y = orris_x;\n  gl_Position = ftransform();\n x = " + row.value + "; }\n");
    EXPECT_EQ(verdict(vertex, fragment), "") << row.out;
  }
}

TEST(interfaceRepair, a_scalar_and_a_vector_are_not_converted) {
  EXPECT_FALSE(
      repaired(kHead + "out float x;\nvoid main() { x = 1.0; }\n", reading("in vec4 x;", "x")));
}

TEST(interfaceRepair, blocks_arrays_and_used_outputs_stay) {
  EXPECT_FALSE(repaired(kHead + "out Data { vec4 a; } data;\nout float k[2];\nout vec4 c;\n"
                                "void main() { data.a = c = vec4(1); k[0] = 1.0; }\n",
                        kHead +
                            "in Data { vec4 a; } data;\nin float k[2];\nin float more[2];\n"
                            "in vec4 c;\nvoid main() { gl_FragColor = data.a * k[0] + more[1] + "
                            "c; }\n"));
}

TEST(interfaceRepair, a_name_that_means_something_else_is_not_declared_again) {
  EXPECT_FALSE(repaired(kHead + "uniform vec3 tint;\nvoid main() { gl_Position.xyz = tint; }\n",
                        reading("in vec3 tint;", "tint, 1.0")));
}

// Iris declares it before anything is compiled.
TEST(interfaceRepair, a_name_that_the_stage_before_only_uses_is_declared_there) {
  const std::string vertex =
      kHead + "void main() {\n  gl_Position = ftransform();\n  tint = gl_Color.rgb;\n}\n";
  const std::string fragment = reading("varying vec3 tint;", "tint, 1.0");
  EXPECT_EQ(verdict(vertex, fragment), "");
  ASSERT_TRUE(repaired(vertex, fragment));
  EXPECT_THAT(repaired(vertex, fragment)->stages[0].text.text, HasSubstr("out vec3 tint; "));
  EXPECT_FALSE(repaired(kHead + "float tint() { return 1.0; }\n"
                                "void main() { gl_Position = vec4(tint()); }\n",
                        fragment));
}

TEST(interfaceRepair, a_geometry_stage_gets_single_values_of_its_arrays) {
  const StageText vertex = stageOf(Stage::Vertex, kVertex);
  const StageText geometry = stageOf(
      Stage::Geometry,
      "#version 330 compatibility\nlayout(triangles) in;\nlayout(points, max_vertices = 1) out;\n"
      "in vec2 uv[];\nvoid main() { gl_Position = vec4(uv[0], 0.0, 1.0); EmitVertex(); }\n");
  const auto result = repairInterface({&vertex, &geometry});
  ASSERT_TRUE(result);
  EXPECT_THAT(result->stages[0].text.text, HasSubstr("out vec2 uv; void main() { uv = vec2(0);"));
}

TEST(interfaceRepair, errors_behind_the_repair_keep_the_authors_place) {
  EXPECT_THAT(verdict(kHead + "void main() { gl_Position = ftransform() * missing;\n}\n",
                      reading("in vec3 tint;", "tint, 1.0")),
              HasSubstr("/a.vsh:2:44: error: 'missing' : undeclared identifier"));
}

TEST(fileScope, finds_main_and_varyings_past_functions_and_blocks) {
  const std::string text =
      "#version 450\n#extension GL_A : enable\nlayout(location = 2) flat in ivec2 a, b[3];\n"
      "struct S { float in_; } s;\nfloat f(in vec2 p, out float q) { q = p.x; return q; }\n"
      "uniform U { vec4 c; };\nnoperspective out vec4 d;\nvoid main() { { } }\nvoid mainly() {}\n";
  const FileScope scope = readFileScope(text);
  ASSERT_EQ(scope.varyings.size(), 3u);
  EXPECT_EQ(scope.varyings[0].name, "a");
  EXPECT_EQ(scope.varyings[0].qualifiers, "flat ");
  EXPECT_TRUE(scope.varyings[0].layout);
  EXPECT_TRUE(scope.varyings[1].array);
  EXPECT_EQ(scope.varyings[2].type, "vec4");
  EXPECT_FALSE(scope.varyings[2].input);
  EXPECT_EQ(text.substr(scope.mainBegin, scope.mainEnd - scope.mainBegin), " { } ");
  EXPECT_EQ(scope.first, text.find("layout"));
}

TEST(fileScope, text_that_ends_anywhere_is_read) {
  const std::string text =
      "out vec2 a;\nvoid main() { if (x) { y(z[1]); } }\nout U { vec2 b; } c;\n";
  for (std::size_t i = 0; i <= text.size(); ++i) readFileScope(text.substr(0, i));
}

TEST(textEdits, places_move_with_their_tokens) {
  const StageText stage = stageOf(Stage::Vertex, "#version 330\nint a; int b;\nint c;\n");
  const std::string& text = stage.text.text;
  TextEdits edits;
  edits.insert(text.find("int a"), "made ");
  edits.rename(text.find('a', 20), 1, "long_name");
  const MappedText out = edits.apply(stage.text);
  EXPECT_EQ(out.text,
            "#version 450 compatibility\nmade int long_name = 0; int b = 0;\nint c = 0;\n");
  EXPECT_EQ(out.locate(2, 1).file, "");
  EXPECT_EQ(out.locate(2, 6).column, 1);
  EXPECT_EQ(out.locate(2, 10).column, 5);
  EXPECT_EQ(out.locate(2, 29).column, 12);
  EXPECT_EQ(out.locate(3, 5).line, 3);
}

}  // namespace
}  // namespace orris
