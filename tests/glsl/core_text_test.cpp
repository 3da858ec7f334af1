#include <orris/glsl/rewrite/core_text.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "glsl/glsl_test.h"

namespace orris {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

StageText writtenStage(Stage stage, const std::string& text) {
  Diagnostics diagnostics;
  const std::string file = std::string("/a.") + stageExtension(stage);
  TokenStream stream = preprocess(test::flatten({{file, text}}, file), {}, diagnostics);
  rewrite(stream, stage);
  return {stage, print(stream)};
}

std::vector<StageText> coreOf(const std::string& vertex, const std::string& fragment) {
  const StageText from = writtenStage(Stage::Vertex, vertex);
  const StageText to = writtenStage(Stage::Fragment, fragment);
  return coreTexts({&from, &to});
}

/// What glslang says of the core text.
std::string coreVerdict(const std::string& vertex, const std::string& fragment) {
  const std::vector<StageText> core = coreOf(vertex, fragment);
  Diagnostics diagnostics;
  validateWithGlslang(
      {&core[0], &core[1]}, [](const std::string&, int) { return ""; }, diagnostics);
  return test::format(diagnostics);
}

const std::string kOldHead = "#version 120\n";
const std::string kOldVertex = kOldHead + "void main() {\n  gl_Position = ftransform();\n}\n";
const std::string kOldFragment = kOldHead + "void main() {\n  gl_FragColor = vec4(1);\n}\n";

TEST(coreText, names_of_old_glsl_become_attributes_and_uniforms_declared_once) {
  const auto core = coreOf(kOldHead + "void main() {\n  gl_Position = gl_ModelViewMatrix * gl_Vertex;\n"
                                   "  gl_Position += gl_Vertex;\n}\n",
                           kOldFragment);
  EXPECT_EQ(core[0].text.text,
            "#version 450 core\nuniform mat4 iris_ModelView; in vec4 iris_Position; void main() {\n"
            "  gl_Position = iris_ModelView * iris_Position;\n  gl_Position += iris_Position;\n}\n");
}

TEST(coreText, every_name_of_a_vertex_stage_compiles) {
  EXPECT_EQ(
      coreVerdict(
          kOldHead +
              "void main() {\n"
              "  vec4 v = gl_Vertex + gl_Color + gl_SecondaryColor + gl_MultiTexCoord0 + gl_MultiTexCoord1\n"
              "    + gl_MultiTexCoord2 + gl_MultiTexCoord3 + gl_MultiTexCoord4 + gl_MultiTexCoord7\n"
              "    + vec4(gl_Normal, gl_FogCoord) + gl_Fog.color * gl_Fog.scale;\n"
              "  v = gl_ModelViewMatrix * gl_ProjectionMatrix * gl_ModelViewProjectionMatrix * v;\n"
              "  v = gl_ModelViewMatrixInverse * gl_ProjectionMatrixInverse * v;\n"
              "  v = gl_ModelViewProjectionMatrixInverse * gl_ModelViewMatrixTranspose * v;\n"
              "  v = gl_ProjectionMatrixInverseTranspose * gl_TextureMatrix[1] * v;\n"
              "  v.xyz = gl_NormalMatrix * v.xyz * gl_NormalScale;\n"
              "  gl_Position = ftransform();\n  gl_ClipVertex = v;\n  gl_FogFragCoord = 1.0;\n"
              "  gl_FrontColor = gl_BackColor = v;\n"
              "  gl_FrontSecondaryColor = gl_BackSecondaryColor = v;\n"
              "  gl_TexCoord[gl_MaxTextureCoords - 1] = v;\n}\n",
          kOldFragment),
      "");
}

TEST(coreText, the_stage_before_declares_what_a_fragment_stage_reads) {
  const std::string fragment =
      kOldHead +
      "void main() {\n  gl_FragColor = gl_Color + gl_TexCoord[2] * gl_FogFragCoord;\n}\n";
  EXPECT_EQ(coreVerdict(kOldVertex, fragment), "");
  EXPECT_THAT(coreOf(kOldVertex, fragment)[0].text.text,
              HasSubstr("out vec4 iris_FrontColor; out vec4 iris_TexCoords[8]; "
                        "out float iris_FogFragCoord; "));
}

TEST(coreText, the_alpha_test_stands_behind_the_authors_main) {
  const std::string text =
      coreOf(kOldVertex, kOldHead + "void main() {\n  gl_FragData[1] = vec4(1);\n  return;\n}\n")[1]
          .text.text;
  EXPECT_THAT(text, HasSubstr("void iris_main() {\n  iris_FragData[1] = vec4(1);\n  return;\n}\n"
                              " void main() { iris_main(); "
                              "if (iris_alphaFails(iris_FragData[0].a)) discard; }"));
}

TEST(coreText, a_color_for_all_buffers_reaches_all) {
  EXPECT_EQ(coreVerdict(kOldVertex, kOldFragment), "");
  EXPECT_THAT(coreOf(kOldVertex, kOldFragment)[1].text.text,
              HasSubstr("iris_FragData[i] = iris_FragColor; if (iris_alphaFails("));
}

TEST(coreText, outputs_of_the_authors_own_get_no_alpha_test) {
  const std::string fragment = "#version 330\nout vec4 color;\nvoid main() { color = vec4(1); }\n";
  EXPECT_EQ(coreOf(kOldVertex, fragment)[1].text.text,
            "#version 450 core\nout vec4 color;\nvoid main() { color = vec4(1); }\n");
}

TEST(coreText, outputs_beside_fragment_data_keep_the_test_of_the_first) {
  const std::string fragment =
      "#version 330 compatibility\nlayout(location = 1) out vec4 other;\n"
      "void main() { gl_FragData[0] = vec4(1); other = vec4(0); }\n";
  EXPECT_THAT(coreOf(kOldVertex, fragment)[1].text.text,
              HasSubstr("if (iris_alphaFails(orris_FragData0.a)) discard;"));
  EXPECT_EQ(coreVerdict(kOldVertex, fragment), "");
}

TEST(coreText, members_and_names_of_other_stages_stay) {
  const StageText compute = writtenStage(
      Stage::Compute,
      "#version 430 compatibility\nlayout(local_size_x = 1) in;\nstruct S { float gl_Fog; };\n"
      "uniform S s;\nvoid main() { float gl_Color = s.gl_Fog; }\n");
  const std::string text = coreTexts({&compute})[0].text.text;
  EXPECT_THAT(text, HasSubstr("#version 430 core\n"));
  EXPECT_THAT(text, HasSubstr("float gl_Color = s.gl_Fog;"));
  EXPECT_THAT(text, Not(HasSubstr("iris_AlphaFunction")));
}

TEST(coreText, the_authors_places_stay) {
  const auto core = coreOf(
      kOldHead + "void main() {\n  gl_Position = gl_Vertex * undeclared;\n}\n", kOldFragment);
  const std::string line = "  gl_Position = iris_Position * ";
  const SourceLocation at = core[0].text.locate(3, int(line.size()) + 1);
  EXPECT_EQ(at.line, 3);
  EXPECT_EQ(at.column, 29);
}

}  // namespace
}  // namespace orris
