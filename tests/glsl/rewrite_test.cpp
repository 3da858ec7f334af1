#include <orris/glsl/rewrite/rewrite.h>

#include <gtest/gtest.h>

#include "glsl/glsl_test.h"

namespace orris {
namespace {

using test::rewritten;
using test::ruleNames;

// Rules that fired, apart from version.
std::string fired(const std::string& text, Stage stage = Stage::Fragment) {
  RewriteResult result;
  rewritten(text, stage, &result);
  return ruleNames(result);
}

TEST(rewrite, stages_have_their_file_extension_and_name) {
  EXPECT_STREQ(stageExtension(Stage::TessEvaluation), "tes");
  EXPECT_STREQ(stageName(Stage::TessEvaluation), "tessellation evaluation");
  EXPECT_STREQ(stageExtension(Stage::Compute), "csh");
  EXPECT_STREQ(stageName(Stage::Vertex), "vertex");
}

TEST(rewrite, modern_code_is_not_touched) {
  const std::string text =
      "layout(location = 0) out vec4 color;\nin vec2 uv;\nuniform sampler2D colortex0;\n"
      "const float K = 2.0 * float(gl_MaxDrawBuffers);\nfloat f(float x) { return x * K; }\n"
      "void main() { color = texture(colortex0, uv) * f(mix(0.0, 1.0, true)); }\n";
  EXPECT_EQ(rewritten("#version 450 compatibility\n" + text), text);
  EXPECT_EQ(fired("#version 450 compatibility\n" + text), "");
}

TEST(version, becomes_450_compatibility_except_for_compute) {
  const auto version = [](const std::string& text, Stage stage) {
    Diagnostics diagnostics;
    TokenStream stream = preprocess(test::source(text), {}, diagnostics);
    rewrite(stream, stage);
    return std::to_string(stream.version) + " " + stream.profile;
  };
  EXPECT_EQ(version("#version 120\n", Stage::Vertex), "450 compatibility");
  EXPECT_EQ(version("", Stage::Fragment), "450 compatibility");
  EXPECT_EQ(version("#version 330 core\n", Stage::Geometry), "450 compatibility");
  EXPECT_EQ(version("#version 310\n", Stage::Compute), "430 ");
  EXPECT_EQ(version("#version 450 compatibility\n", Stage::Compute), "450 compatibility");
}

TEST(version, is_reported_at_the_directive_when_it_changed) {
  RewriteResult result;
  rewritten("\n#version 120\n", Stage::Fragment, &result);
  ASSERT_EQ(result.rules.size(), 1u);
  EXPECT_EQ(result.rules[0].rule, "version");
  EXPECT_EQ(result.rules[0].first, (SourceLocation{"/a.fsh", 2, 1}));
  rewritten("#version 450 compatibility\n", Stage::Fragment, &result);
  EXPECT_TRUE(result.rules.empty());
}

TEST(extensions, core_ones_are_dropped_and_others_stay) {
  EXPECT_EQ(
      rewritten(
          "#extension GL_EXT_gpu_shader4 : require\n#extension GL_NV_foo : enable\nin int a;\n"),
      "#extension GL_NV_foo : enable\nin int a;\n");
  EXPECT_EQ(fired("#extension GL_ARB_shader_texture_lod : enable\n"), "extensions*1@1:1");
  EXPECT_EQ(fired("#extension GL_NV_foo : enable\n"), "");
}

TEST(attribute_varying, becomes_in_and_out_by_stage) {
  const std::string text = "attribute vec4 a;\nflat varying vec2 b;\n";
  EXPECT_EQ(rewritten(text, Stage::Vertex), "in vec4 a;\nflat out vec2 b;\n");
  EXPECT_EQ(rewritten("varying vec2 b;\n", Stage::Fragment), "in vec2 b;\n");
  EXPECT_EQ(rewritten("varying vec2 b;\n", Stage::Geometry), "varying vec2 b;\n");
  EXPECT_EQ(fired(text, Stage::Vertex), "attribute-varying*2@1:1");
}

TEST(texture_functions, get_their_present_names) {
  EXPECT_EQ(
      rewritten("vec4 a = texture2D(s, u) + texture2DLod(s, u, 0) + texelFetch2D (s, i, 0);\n"),
      "vec4 a = texture(s, u) + textureLod(s, u, 0) + texelFetch (s, i, 0);\n");
  EXPECT_EQ(rewritten("vec4 a = texture2DGradARB(s, u, x, y), b = textureSize2D(s, 0);\n"),
            "vec4 a = textureGrad(s, u, x, y), b = textureSize(s, 0);\n");
}

TEST(texture_functions, shadow_lookups_give_a_vector) {
  EXPECT_EQ(rewritten("float a = shadow2D(s, vec3(u, f(1))).x * shadow2DLod(s, v, 0).z;\n"),
            "float a = vec4(texture(s, vec3(u, f(1)))).x * vec4(textureLod(s, v, 0)).z;\n");
}

TEST(texture_functions, names_of_the_pack_and_other_uses_stay) {
  const std::string own =
      "vec4 texture2DLod(sampler2D s, vec2 u) { return vec4(0); }\n"
      "vec4 a = texture2DLod(s, u);\n";
  EXPECT_EQ(rewritten(own), own);
  EXPECT_EQ(fired("uniform int texture2D;\n"), "");
  EXPECT_EQ(rewritten("float f() { return texture2D(s, u).x; } float g = f();\n"),
            "float f() { return texture(s, u).x; } float g = f();\n");
}

TEST(texture_name, sampler_of_that_name_becomes_gtexture) {
  EXPECT_EQ(
      rewritten(
          "uniform sampler2D texture;\nvec4 a = texture2D(texture, u) + texture(texture, v);\n"),
      "uniform sampler2D gtexture;\nvec4 a = texture(gtexture, u) + texture(gtexture, v);\n");
  EXPECT_EQ(rewritten("uniform sampler2D gcolor;\nvec4 a = texture2D(gcolor, u);\n"),
            "uniform sampler2D gtexture;\nvec4 a = texture(gtexture, u);\n");
}

TEST(texture_name, a_second_declaration_of_gtexture_is_dropped) {
  EXPECT_EQ(rewritten("uniform sampler2D gtexture;\nuniform sampler2D texture;\nvec4 a = "
                      "texture(texture, u);\n"),
            "uniform sampler2D gtexture;\nvec4 a = texture(gtexture, u);\n");
}

TEST(texture_name, other_variables_get_a_name_of_the_host) {
  EXPECT_EQ(
      rewritten(
          "vec4 f(sampler2D texture, vec2 u) { return texture2D(texture, u); } int g = f(1);\n"),
      "vec4 f(sampler2D orris_texture, vec2 u) { return texture(orris_texture, u); } int g = "
      "f(1);\n");
}

TEST(texture_name, calls_and_an_undeclared_gcolor_stay) {
  EXPECT_EQ(fired("uniform sampler2D t;\nvec4 a = texture(t, u) * gcolor;\n"), "");
}

TEST(reserved_names, sample_as_a_name_is_renamed_in_every_version) {
  EXPECT_EQ(
      rewritten(
          "#version 400\nfloat f() { vec3 sample = vec3(0); return sample.x; } float g = f();\n"),
      "float f() { vec3 orris_sample = vec3(0); return orris_sample.x; } float g = f();\n");
}

TEST(reserved_names, qualifiers_stay) {
  EXPECT_EQ(
      fired("#version 400\nsample in vec2 uv;\nflat in int i;\nlayout(location = 1) in vec2 b;\n"),
      "");
  EXPECT_EQ(fired("#version 120\nflat in int i;\nuint a = 1u;\nlayout(location = 0) out vec4 b;\n"),
            "");
}

TEST(reserved_names, words_newer_than_the_version_are_renamed) {
  EXPECT_EQ(fired("#version 120\nfloat filter = 1.0;\nfloat a = filter;\n"),
            "reserved-names*2@2:7");
  EXPECT_EQ(fired("#version 420\nvec2 shared = vec2(0), x = shared;\n"), "reserved-names*2@2:6");
  EXPECT_EQ(fired("#version 430\nvec2 shared = vec2(0);\n"), "");
}

TEST(stray_semicolon, is_dropped_at_file_scope_only) {
  EXPECT_EQ(rewritten("in int a;;\nvoid main() { ; };\n"), "in int a;\nvoid main() { ; }\n");
  EXPECT_EQ(fired("struct S { int a; };\nvoid main() {}\n"), "");
}

TEST(unused_functions, named_nowhere_else_are_removed) {
  EXPECT_EQ(
      rewritten(
          "float f() { return undeclared; }\nfloat g() { return 1; }\nvoid main() { g(); }\n"),
      "float g() { return 1; }\nvoid main() { g(); }\n");
  EXPECT_EQ(fired("in int a;\n  float f() { if (x) { y; } }\nvoid main() {}\n"),
            "unused-functions*1@2:9");
}

TEST(unused_functions, overloads_prototypes_and_main_stay) {
  EXPECT_EQ(fired("float f() { return 1; }\nfloat f(int a) { return 2; }\nvoid main() {}\n"), "");
  EXPECT_EQ(fired("float f();\nfloat f() { return 1; }\n"), "");
}

TEST(global_const, loses_const_when_the_initialiser_is_not_constant) {
  EXPECT_EQ(rewritten("uniform float u;\nconst float a = u * 2.0;\n"),
            "uniform float u;\n      float a = u * 2.0;\n");
  EXPECT_EQ(rewritten("float f(){return 1.0;}\nconst float a = f();\nconst float b = a + "
                      "1.0;\nconst float c = 1.0;\n"),
            "float f(){return 1.0;}\n      float a = f();\n      float b = a + 1.0;\nconst float c "
            "= 1.0;\n");
  EXPECT_EQ(fired("uniform sampler2D s;\nconst vec4 a = texelFetch(s, ivec2(0), 0);\n"),
            "global-const*1@2:1");
  EXPECT_EQ(fired("uniform U { float m; };\nconst float a = m;\n"), "global-const*1@2:1");
  EXPECT_EQ(fired("const float a = 1.0, b = gl_FragCoord.x;\n"), "global-const*1@1:1");
}

TEST(global_const, loses_const_when_glslang_cannot_fold_the_initialiser) {
  for (const char* value : {"transpose(mat3(1.0))[0].x", "determinant(mat2(1.0))", "fma(1, 2, 3)",
                            "unpackHalf2x16(3u).x", "tanh(1.0)"}) {
    EXPECT_EQ(fired(std::string("const float a = ") + value + ";\n"), "global-const*1@1:1")
        << value;
  }
}

TEST(global_const, keeps_const_of_constant_expressions_and_locals) {
  EXPECT_EQ(fired("struct S { float u; };\nuniform float u;\nconst S s = S(1.0);\nconst float a = "
                  "s.u + sin(2.0);\n"
                  "const float t[2] = float[2](1.0, a);\nconst int n = gl_MaxDrawBuffers;\n"),
            "");
  EXPECT_EQ(fired("uniform float u;\nvoid main() { const float a = u; }\n"), "");
  EXPECT_EQ(
      fired(
          "uniform float a;\nuniform U { float b; } block;\nconst float c = 2.0;\nfloat d = a;\n"),
      "");
}

constexpr const char* kMixTail = "vec3 a, b; bool c; float x; bvec3 v;\nvoid main() { ";

std::string mixOf(const std::string& expression) {
  const std::string text = rewritten(std::string(kMixTail) + expression + " }\n");
  const std::size_t at = text.find("void main() { ") + 14;
  const bool overloads =
      text.find("vec3 orris_mix(vec3 x, vec3 y, bool a) { return a ? y : x; }") ==
      std::string::npos;
  const std::string body = text.substr(at, text.rfind(" }") - at);
  EXPECT_EQ(overloads, body.find("orris_mix") == std::string::npos);
  return body;
}

TEST(mix_bool, scalar_condition_on_vectors_is_renamed) {
  EXPECT_EQ(mixOf("a = mix(a, b, c);"), "a = orris_mix(a, b, c);");
  EXPECT_EQ(mixOf("a = mix(a * 2.0, f(b, 1), x < 1.0);"),
            "a = orris_mix(a * 2.0, f(b, 1), x < 1.0);");
  EXPECT_EQ(mixOf("a = mix(a, b, (c && !c));"), "a = orris_mix(a, b, (c && !c));");
  EXPECT_EQ(mixOf("a = mix(a, b, true);"), "a = orris_mix(a, b, true);");
  EXPECT_EQ(mixOf("a = mix(a, b, bool(x));"), "a = orris_mix(a, b, bool(x));");
  EXPECT_EQ(mixOf("a = mix(a, b, any(v));"), "a = orris_mix(a, b, any(v));");
  EXPECT_EQ(mixOf("a = mix(a, b, v.x);"), "a = orris_mix(a, b, v.x);");
  EXPECT_EQ(mixOf("a = mix(a, b, x > 0.0 ? true : c);"),
            "a = orris_mix(a, b, x > 0.0 ? true : c);");
}

TEST(mix_bool, other_calls_stay) {
  for (const char* call :
       {"a = mix(a, b, x);", "a = mix(a, b, v);", "a = mix(a, b, float(x < 1.0));",
        "x = mix(1.0, x, c);", "x = mix(a.x, b.y, c);", "a = mix(a, b, lessThan(a, b));",
        "a = mix(a, b, f(x, c));", "a = mix(a, b, x < 1.0 ? 0.0 : 1.0);", "a = mix(b, c);"}) {
    EXPECT_EQ(mixOf(call), call);
  }
}

TEST(mix_bool, the_nearest_declaration_counts) {
  EXPECT_EQ(fired("in vec3 a;\nuniform bool c;\nvec3 f() { float c = 1.0; return mix(a, a, c); "
                  "}\nvec3 g = f();\n"),
            "");
  EXPECT_EQ(fired("in vec3 a;\nin float c;\nvec3 f() { bool d = true, c = d; return mix(a, a, c); "
                  "}\nvec3 g = f();\n"),
            "mix-bool*1@3:41");
  EXPECT_EQ(fired("in vec3 a;\nvec3 f(bool x, float c) { return mix(a, a, c); }\nvec3 g = f();\n"),
            "");
}

TEST(mix_bool, a_mix_of_the_pack_is_left_alone) {
  EXPECT_EQ(fired("in vec3 a;\nvec3 mix(vec3 x, vec3 y, bool z) { return x; }\nvec3 g = mix(a, a, "
                  "true);\n"),
            "");
}

TEST(entity_id, of_no_block_is_zero_as_an_unsigned_number) {
  const auto id = [](const std::string& expression) {
    const std::string head = "in vec4 mc_Entity;\nuint f() { return ";
    const std::string text = rewritten(head + expression + "; }\nuint g = f();\n", Stage::Vertex);
    return text.substr(head.size(), text.find("; }") - head.size());
  };
  EXPECT_EQ(id("uint(mc_Entity.x)"), "uint(max(mc_Entity.x, 0.0))");
  EXPECT_EQ(id("uint((mc_Entity.x - 1000.0) + 0.25) + 1u"),
            "uint(max((mc_Entity.x - 1000.0) + 0.25, 0.0)) + 1u");
  EXPECT_EQ(id("uint(h(mc_Entity.x) + h(mc_Entity.y))"),
            "uint(max(h(mc_Entity.x) + h(mc_Entity.y), 0.0))");
  EXPECT_EQ(id("uint(x) + int(mc_Entity.x)"), "uint(x) + int(mc_Entity.x)");
  EXPECT_EQ(id("h(uint(x), mc_Entity.x)"), "h(uint(x), mc_Entity.x)");
  EXPECT_EQ(fired("uint f() { return uint(mc_Entity.x); }\nuint g = f();\n", Stage::Fragment), "");
}

// Iris: CompatibilityTransformer.
TEST(frag_data, becomes_outputs_beside_outputs_of_the_pack) {
  EXPECT_EQ(
      rewritten("layout(location = 1) out vec4 more;\n"
                "void main() { gl_FragData[0] = more = vec4(1.0); gl_FragData[2].x = 0.0; }\n"),
      "layout(location = 0) out vec4 orris_FragData0;\n"
      "layout(location = 2) out vec4 orris_FragData2;\n"
      "layout(location = 1) out vec4 more;\n"
      "void main() { orris_FragData0 = more = vec4(1.0); orris_FragData2.x = 0.0; }\n");
  EXPECT_EQ(fired("out vec4 a;\nvoid main() { gl_FragColor = a = vec4(1.0); }\n"),
            "frag-data*1@2:15");
}

TEST(frag_data, stays_where_it_is_the_only_output) {
  EXPECT_EQ(fired("void main() { gl_FragData[0] = vec4(1.0); }\n"), "");
  EXPECT_EQ(fired("out vec4 a;\nvoid main() { int i = 0; gl_FragData[i] = a; }\n"), "");
  EXPECT_EQ(fired("out vec4 a;\nvoid main() { a = vec4(1.0); }\n"), "");
}

TEST(frag_data, is_remembered_for_the_alpha_test) {
  RewriteResult result;
  rewritten("out vec4 a;\nvoid main() { gl_FragColor = a = vec4(1.0); }\n", Stage::Fragment,
            &result);
  EXPECT_TRUE(result.writesFragData);
}

TEST(out_color, gets_its_number_as_location) {
  EXPECT_EQ(rewritten("out vec4 outColor0;\n/* x */ flat out ivec2 outColor7;\n"),
            "layout(location = 0) out vec4 outColor0;\nlayout(location = 7) flat out ivec2 "
            "outColor7;\n");
  EXPECT_EQ(
      fired("layout(location = 3) out vec4 outColor0;\nout vec4 outColor8;\nout vec4 color;\n"),
      "");
  EXPECT_EQ(fired("out vec4 outColor0;\n", Stage::Vertex), "");
}

TEST(host_names, are_declared_when_used_and_undeclared) {
  EXPECT_EQ(rewritten("int a = entityId;\n"), "uniform int entityId;\nint a = entityId;\n");
  EXPECT_EQ(rewritten("vec4 a = projectionMatrix * (modelViewMatrix * vec4(vaPosition, 1.0));\n",
                      Stage::Vertex),
            "uniform mat4 modelViewMatrix;\nuniform mat4 projectionMatrix;\nin vec3 vaPosition;\n"
            "vec4 a = projectionMatrix * (modelViewMatrix * vec4(vaPosition, 1.0));\n");
  EXPECT_EQ(fired("\nint a = entityId + entityId;\n"), "host-names*1@2:9");
}

TEST(host_names, declared_ones_stay_as_they_are) {
  EXPECT_EQ(fired("uniform float x, entityId;\nfloat a = entityId;\n"), "");
  EXPECT_EQ(fired("in vec3 vaPosition;\nvec3 a = vaPosition;\n", Stage::Vertex), "");
  EXPECT_EQ(fired("vec3 a = vaPosition;\n", Stage::Fragment), "");
}

TEST(rewrite, says_whether_a_fragment_stage_writes_gl_FragData) {
  const auto writes = [](const std::string& text, Stage stage) {
    RewriteResult result;
    rewritten(text, stage, &result);
    return result.writesFragData;
  };
  EXPECT_TRUE(writes("void main() { gl_FragData[0] = vec4(1); }\n", Stage::Fragment));
  EXPECT_TRUE(writes("void main() { gl_FragColor = vec4(1); }\n", Stage::Fragment));
  EXPECT_FALSE(
      writes("out vec4 c; // gl_FragData\nvoid main() { c = vec4(1); }\n", Stage::Fragment));
  EXPECT_FALSE(writes("void f() { gl_FragData[0] = vec4(1); }\nvoid main() {}\n", Stage::Fragment));
}

}  // namespace
}  // namespace orris
