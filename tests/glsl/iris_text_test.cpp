#include <orris/glsl/iris/iris_text.h>

#include <gtest/gtest.h>

#include "glsl/glsl_test.h"
#include <orris/glsl/iris/iris_names.h>

namespace orris {
namespace {

constexpr IrisProgram kFullscreen{.patch = IrisPatch::Fullscreen};
constexpr IrisProgram kVanilla{.patch = IrisPatch::Vanilla};
constexpr IrisProgram kEntities{.patch = IrisPatch::Vanilla, .entities = true};
constexpr IrisProgram kTerrain{.patch = IrisPatch::Terrain};
constexpr IrisProgram kClouds{.patch = IrisPatch::Vanilla, .clouds = true};
constexpr IrisProgram kDistant{.patch = IrisPatch::DistantHorizons};
constexpr IrisProgram kDistantGeneric{.patch = IrisPatch::DistantHorizons, .generic = true};

TokenStream streamOf(const std::string& text, Stage stage, const IrisProgram& program,
                     RewriteResult* result = nullptr) {
  Diagnostics diagnostics;
  TokenStream stream = preprocess(test::source(text), {}, diagnostics);
  const RewriteResult applied = rewriteAsIris(stream, stage, program);
  if (result) *result = applied;
  return stream;
}

/// The text that Iris would make, without the #version line.
std::string sent(const std::string& text, const IrisProgram& program,
                 Stage stage = Stage::Fragment) {
  std::string sent;
  for (const std::string& line : test::splitLines(print(streamOf(text, stage, program)).text)) {
    // The host's lines stand above the author's, whose indentation does not matter here.
    const std::size_t start = line.find_first_not_of(' ');
    if (start != std::string::npos && !line.starts_with("#version"))
      sent += line.substr(start) + "\n";
  }
  return sent;
}

std::string versionSent(const std::string& text, const IrisProgram& program,
                        Stage stage = Stage::Fragment) {
  const TokenStream stream = streamOf(text, stage, program);
  return std::to_string(stream.version) + " " + stream.profile;
}

TEST(IrisVersion, is_the_authors_and_core_but_at_least_330) {
  EXPECT_EQ(versionSent("#version 120\n", kFullscreen), "330 ");
  EXPECT_EQ(versionSent("#version 330 compatibility\n", kVanilla), "330 ");
  EXPECT_EQ(versionSent("#version 430 core\n", kTerrain), "430 ");
  EXPECT_EQ(
      versionSent("#version 430 compatibility\n", {.patch = IrisPatch::Compute}, Stage::Compute),
      "430 ");
  EXPECT_EQ(
      versionSent("#version 330 compatibility\n", {.patch = IrisPatch::Vanilla, .lines = true}),
      "330 compatibility");
}

TEST(IrisVersion, is_raised_by_an_extension_that_a_later_version_contains) {
  EXPECT_EQ(versionSent("#version 330\n#extension GL_ARB_gpu_shader5 : enable\n", kFullscreen),
            "400 ");
  EXPECT_EQ(versionSent("#version 330\n#extension GL_ARB_gpu_shader5 : disable\n", kFullscreen),
            "330 ");
  EXPECT_EQ(versionSent("#version 120\n#extension GL_ARB_shader_texture_lod : enable\n", kVanilla),
            "330 ");
  EXPECT_EQ(sent("#version 330\n#extension GL_NV_foo : enable\nin int a;\n", kFullscreen),
            "#extension GL_NV_foo : enable\nin int a;\n");
}

TEST(IrisVersion, raised_by_an_extension_leaves_old_glsl_what_it_is) {
  const std::string text =
      "#version 120\n#extension GL_ARB_shader_image_load_store : enable\nmat4 m = "
      "gl_TextureMatrix[1];\n";
  EXPECT_EQ(versionSent(text, kTerrain), "420 ");
  EXPECT_EQ(sent(text, kTerrain), "mat4 m = mat4(1.0);\n");
}

TEST(IrisNames, stand_for_the_built_ins_that_the_patcher_of_the_program_knows) {
  EXPECT_EQ(
      sent("#version 120\nvoid main() { gl_Position = gl_Vertex; }\n", kFullscreen, Stage::Vertex),
      "in vec3 Position;\nvoid main() { gl_Position = vec4(Position, 1.0); }\n");
  EXPECT_EQ(sent("#version 120\nvec3 n = gl_NormalMatrix * gl_Normal;\n", kVanilla, Stage::Vertex),
            "uniform mat3 iris_NormalMat;\nin vec3 iris_Normal;\n"
            "vec3 n = iris_NormalMat * iris_Normal;\n");
  EXPECT_EQ(sent("#version 330 core\nvec4 v = gl_Vertex;\n", kTerrain, Stage::Vertex),
            "vec4 v = gl_Vertex;\n");
  EXPECT_EQ(sent("#version 120\nmat4 m = gl_ModelViewMatrixInverse;\n", kFullscreen),
            "mat4 m = gl_ModelViewMatrixInverse;\n");
}

TEST(IrisNames, of_core_programs_are_declared_where_the_author_does_not) {
  EXPECT_EQ(sent("#version 330 core\nvec3 p = vaPosition;\n", kVanilla, Stage::Vertex),
            "in vec3 vaPosition;\nvec3 p = vaPosition;\n");
  EXPECT_EQ(sent("#version 330 core\nin vec3 vaPosition;\nvec3 p = vaPosition;\n", kVanilla,
                 Stage::Vertex),
            "in vec3 vaPosition;\nvec3 p = vaPosition;\n");
  EXPECT_EQ(sent("#version 120\nint i = entityId;\n", kEntities),
            "uniform int entityId;\nint i = entityId;\n");
  EXPECT_EQ(sent("#version 120\nint i = entityId;\n", kTerrain), "int i = entityId;\n");
}

TEST(IrisNames, that_iris_declares_are_there_twice_when_the_author_declares_them_too) {
  EXPECT_EQ(sent("#version 120\nuniform mat4 u_ModelViewMatrix;\n", kVanilla, Stage::Vertex),
            "uniform mat4 u_ModelViewMatrix;\n");
  const std::string terrain =
      sent("#version 120\nuniform mat4 u_ModelViewMatrix;\n", kTerrain, Stage::Vertex);
  EXPECT_EQ(terrain.find("layout(std140) uniform u_Globals"), 0u);
  EXPECT_NE(terrain.find("\nuniform mat4 u_ModelViewMatrix;\n"), std::string::npos);
  EXPECT_EQ(sent("#version 120\nin float mc_chunkFade;\n", kVanilla, Stage::Vertex),
            "const float mc_chunkFade = -1.0;\nin float mc_chunkFade;\n");
  EXPECT_EQ(sent("#version 120\nout vec3 Position;\n", kFullscreen, Stage::Vertex),
            "in vec3 Position;\nout vec3 Position;\n");
}

TEST(IrisNames, a_matrix_that_shares_its_declaration_stays_beside_that_of_iris) {
  const std::string alone = "#version 330 core\nuniform mat4 modelViewMatrix;\n";
  const std::string shared = "#version 330 core\nuniform mat4 modelViewMatrix, other;\n";
  EXPECT_EQ(sent(alone, kTerrain, Stage::Vertex), "uniform mat4 modelViewMatrix;\n");
  EXPECT_EQ(sent(shared, kTerrain, Stage::Vertex),
            "uniform mat4 modelViewMatrix;\nuniform mat4 modelViewMatrix, other;\n");
  EXPECT_EQ(sent(shared, kVanilla, Stage::Vertex), "uniform mat4 modelViewMatrix, other;\n");
}

TEST(IrisNames, a_function_of_iris_keeps_the_authors_of_that_name) {
  const std::string text =
      "#version 120\nvec2 signNotZero(vec2 v) { return v * 2.0; }\nvoid main() { }\n";
  EXPECT_EQ(sent(text, kTerrain, Stage::Vertex),
            "vec2 signNotZero(vec2 v) { return v; }\n"
            "vec2 signNotZero(vec2 v) { return v * 2.0; }\nvoid main() { }\n");
  EXPECT_EQ(sent(text, kVanilla, Stage::Vertex).find("signNotZero"), std::string::npos);
}

/// Does Iris declare what the author declares as well?
bool isTwice(const std::string& declaration, const IrisProgram& program) {
  const std::string text = sent("#version 120\n" + declaration + "\n", program, Stage::Vertex);
  const std::size_t first = text.find(declaration);
  return first != std::string::npos && text.find(declaration, first + 1) != std::string::npos;
}

TEST(IrisNames, of_clouds_and_distant_terrain_are_there_beside_the_authors) {
  EXPECT_TRUE(isTwice("uniform isamplerBuffer CloudFaces;", kClouds));
  EXPECT_FALSE(isTwice("uniform isamplerBuffer CloudFaces;", kVanilla));
  EXPECT_TRUE(isTwice("uniform vec3 modelOffset;", kDistant));
  EXPECT_FALSE(isTwice("uniform vec3 modelOffset;", kDistantGeneric));
  EXPECT_TRUE(isTwice("uniform int uSkyLight;", kDistantGeneric));
  EXPECT_FALSE(isTwice("uniform int uSkyLight;", kDistant));
  EXPECT_TRUE(isTwice("vec3 _vert_normal;", kDistantGeneric));
  EXPECT_TRUE(isTakenByIris("FLAG_EXTRA_X"));
}

TEST(IrisNames, of_fog_coordinates_are_the_same_in_all_stages) {
  EXPECT_EQ(sent("#version 120\nvoid main() { gl_FogFragCoord = 1.0; }\n", kTerrain,
                 Stage::Geometry),
            "void main() { iris_FogFragCoord = 1.0; }\n");
}

TEST(IrisEntity, is_unsigned_where_sodium_draws_and_the_author_wants_int) {
  const std::string text = "#version 330\nin int mc_Entity;\n";
  EXPECT_EQ(sent(text, kTerrain, Stage::Vertex), "uint mc_Entity = int(0);\n");
  EXPECT_EQ(sent(text, kVanilla, Stage::Vertex), "in int mc_Entity;\n");
  EXPECT_EQ(sent("#version 330\nin vec2 mc_Entity;\n", kTerrain, Stage::Vertex),
            "in vec2 mc_Entity;\n");
}

TEST(IrisEntity, is_an_integer_input_of_a_fragment_stage_where_sodium_draws) {
  const std::string code = "in vec4 mc_Entity;\nfloat a = mc_Entity.x;\n";
  const std::string text = "#version 330 compatibility\n" + code;
  EXPECT_EQ(sent(text, kTerrain),
            "in uint mc_Entity; vec4 iris_Entity = vec4(0);\nfloat a = iris_Entity.x;\n");
  EXPECT_EQ(sent(text, kVanilla), code);
  EXPECT_EQ(sent("#version 330 core\n" + code, kTerrain), code);
}

TEST(ReservedNames, an_authors_noise_stands_in_place_of_the_old_built_in) {
  EXPECT_EQ(sent("#version 330\nfloat noise2(vec2 p) { return p.x; }\n"
                 "float a = noise2(vec2(1.0)) + noise4(1.0).x;\n",
                 kFullscreen),
            "float orris_noise2(vec2 p) { return p.x; }\n"
            "float a = orris_noise2(vec2(1.0)) + noise4(1.0).x;\n");
}

TEST(FloatLiterals, get_a_point) {
  EXPECT_EQ(sent("#version 330\nfloat a = 1f + 0F + 2.f + 1e3f + 3.0f + 0x1f + 7;\n", kFullscreen),
            "float a = 1.0f + 0.0F + 2.f + 1e3f + 3.0f + 0x1f + 7;\n");
}

TEST(IrisNames, texture_matrices_have_an_index_that_is_known) {
  EXPECT_EQ(
      sent("#version 120\nmat4 m = gl_TextureMatrix[7] * gl_TextureMatrix[ i ];\n", kFullscreen),
      "mat4 m = mat4(1.0) * gl_TextureMatrix[ i ];\n");
  EXPECT_EQ(sent("#version 120\nmat4 m = gl_TextureMatrix[1] * gl_TextureMatrix[2];\n", kVanilla),
            "mat4 m = mat4(1.0) * gl_TextureMatrix[2];\n");
}

TEST(IrisNames, a_texture_middle_of_the_authors_keeps_the_old_coordinate_unknown) {
  EXPECT_EQ(sent("#version 120\nvec4 t = gl_MultiTexCoord3;\n", kVanilla, Stage::Vertex),
            "in vec4 mc_midTexCoord;\nvec4 t = mc_midTexCoord;\n");
  EXPECT_EQ(sent("#version 120\nattribute vec2 mc_midTexCoord;\nvec4 t = gl_MultiTexCoord3;\n",
                 kVanilla, Stage::Vertex),
            "in vec2 mc_midTexCoord;\nvec4 t = gl_MultiTexCoord3;\n");
}

TEST(IrisCalls, are_translated_as_far_as_iris_does) {
  EXPECT_EQ(sent("#version 120\nvec4 a = texture2D(s, u) + textureCube(s, u);\n", kFullscreen),
            "vec4 a = texture(s, u) + textureCube(s, u);\n");
  EXPECT_EQ(sent("#version 330 core\nvec4 a = texture2D(s, u);\n", kFullscreen),
            "vec4 a = texture2D(s, u);\n");
  EXPECT_EQ(sent("#version 330 core\nvec4 a = texture2D(s, u);\n", kVanilla),
            "vec4 a = texture(s, u);\n");
}

TEST(IrisFragData, becomes_outputs) {
  EXPECT_EQ(
      sent("#version 120\nvoid main() { gl_FragColor = c; gl_FragData[2] = d; }\n", kFullscreen),
      "layout(location = 0) out vec4 iris_FragData0;\n"
      "layout(location = 2) out vec4 iris_FragData2;\n"
      "void main() { iris_FragData0 = c; iris_FragData2 = d; }\n");
}

TEST(IrisConst, goes_where_a_const_parameter_is_needed) {
  EXPECT_EQ(sent("#version 330\nfloat f(const float x, float y) {\n  const float a = x * 2.0;\n"
                 "  const float b = a + 1.0;\n  const float c = 3.0;\n  return f(b, c);\n}\n",
                 kFullscreen),
            "float f(const float x, float y) {\nfloat a = x * 2.0;\nfloat b = a + 1.0;\n"
            "const float c = 3.0;\nreturn f(b, c);\n}\n");
}

TEST(IrisConst, goes_where_glslang_does_not_fold) {
  EXPECT_EQ(sent("#version 330\nconst mat2 m = inverse(mat2(2.0));\nconst vec2 v = m[0];\n"
                 "const float k = 2.0;\n",
                 kFullscreen),
            "mat2 m = inverse(mat2(2.0));\nvec2 v = m[0];\nconst float k = 2.0;\n");
}

TEST(UnusedFunctions, leave_a_gap_and_are_kept_beside_the_text) {
  const MappedText text =
      print(streamOf("#version 330\nfloat f(float x) {\n  return x;\n}\n"
                     "void main() { }\n",
                     Stage::Fragment, kFullscreen));
  EXPECT_EQ(text.text.find("return"), std::string::npos);
  EXPECT_NE(text.text.find("void main() { }"), std::string::npos);
  ASSERT_EQ(text.unused.size(), 1u);
  EXPECT_EQ(text.unused[0].source, "float f(float x) {\n  return x;\n}");
  const std::string whole = std::string(text.text).replace(
      text.unused[0].offset, text.unused[0].source.size(), text.unused[0].source);
  EXPECT_EQ(whole, "#version 330\nfloat f(float x) {\n  return x;\n}\nvoid main() { }\n");
}

}  // namespace
}  // namespace orris
