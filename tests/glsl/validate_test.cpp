#include <orris/glsl/compile/validate.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <thread>

#include "glsl/glsl_test.h"

namespace orris {
namespace {

using ::testing::StartsWith;

// Preprocesses, rewrites and validates the named entry files as one program.
std::string validated(const test::Files& files, const std::vector<std::string>& entries) {
  Diagnostics diagnostics;
  std::vector<StageText> stages;
  for (const std::string& entry : entries) {
    Stage stage = Stage::Fragment;
    for (Stage candidate : {Stage::Vertex, Stage::Geometry, Stage::Fragment, Stage::Compute}) {
      if (entry.ends_with(stageExtension(candidate))) stage = candidate;
    }
    TokenStream stream = preprocess(test::flatten(files, entry), {}, diagnostics);
    rewrite(stream, stage);
    stages.push_back({stage, print(stream)});
  }
  validateWithGlslang(test::pointersTo(stages), test::linesOf(files), diagnostics);
  return test::format(diagnostics);
}

const std::string kLegacyVertex =
    "#version 120\nvarying vec2 uv;\nvoid main() { gl_Position = ftransform(); uv = "
    "gl_MultiTexCoord0.xy; }\n";

TEST(validate, legacy_program_is_clean_after_rewriting) {
  EXPECT_EQ(validated({{"/a.vsh", kLegacyVertex},
                       {"/a.fsh",
                        "#version 120\n#extension GL_EXT_gpu_shader4 : require\nvarying vec2 uv;\n"
                        "uniform sampler2D texture;;\nuniform float u;\nconst float k = u;\n"
                        "void main() { gl_FragData[0] = texture2D(texture, uv) * k; }\n"}},
                      {"/a.vsh", "/a.fsh"}),
            "");
}

TEST(validate, a_compute_shader_of_an_old_version_has_one_error_and_nothing_is_printed) {
  const test::Files files = {{"/a.csh", "#version 120\nlayout(local_size_x = 1) in;\nvoid main() { }\n"}};
  Diagnostics diagnostics;
  const StageText stage = {Stage::Compute, print(preprocess(test::flatten(files, "/a.csh"), {}, diagnostics))};
  testing::internal::CaptureStdout();
  validateWithGlslang({&stage}, test::linesOf(files), diagnostics);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(test::format(diagnostics),
            "/a.csh:1:1: error: compute shaders require version 420 or above\n  #version 120\n  ^\n");
}

TEST(validate, an_error_three_includes_deep_has_place_chain_and_caret) {
  EXPECT_EQ(
      validated(
          {{"/a.vsh", kLegacyVertex},
           {"/a.fsh", "#version 120\n#include \"/b.glsl\"\nvoid main() { gl_FragColor = f(); }\n"},
           {"/b.glsl", "\n#include \"/c.glsl\"\n"},
           {"/c.glsl", "// c\n#include \"/d.glsl\"\n"},
           {"/d.glsl", "vec4 f() {\n\treturn vec4(1.0) * missing;\n}\n"}},
          {"/a.vsh", "/a.fsh"}),
      "/d.glsl:2:21: error: 'missing' : undeclared identifier\n"
      "  included from /c.glsl:2\n"
      "  included from /b.glsl:2\n"
      "  included from /a.fsh:2\n"
      "  \treturn vec4(1.0) * missing;\n"
      "  \t                   ^\n");
}

TEST(validate, an_error_written_in_a_macro_stands_in_its_definition) {
  EXPECT_EQ(validated({{"/a.vsh", kLegacyVertex},
                       {"/a.fsh",
                        "#version 120\n#define GLOW 2.0 * missing\nvoid main() {\n"
                        "  gl_FragColor = vec4(GLOW);\n}\n"}},
                      {"/a.vsh", "/a.fsh"}),
            "/a.fsh:2:20: error: 'missing' : undeclared identifier\n"
            "  #define GLOW 2.0 * missing\n"
            "                     ^\n"
            "  note: in the expansion of macro 'GLOW' at /a.fsh:4\n");
}

TEST(validate, an_error_in_the_argument_of_a_macro_stands_at_its_use) {
  EXPECT_EQ(validated({{"/a.vsh", kLegacyVertex},
                       {"/a.fsh",
                        "#version 120\n#define TWICE(x) (2.0 * x)\nvoid main() {\n"
                        "  gl_FragColor = vec4(TWICE(missing));\n}\n"}},
                      {"/a.vsh", "/a.fsh"}),
            "/a.fsh:4:29: error: 'missing' : undeclared identifier\n"
            "    gl_FragColor = vec4(TWICE(missing));\n"
            "                              ^\n"
            "  note: expanded from macro 'TWICE', defined at /a.fsh:2\n");
}

// The messages of a fragment shader with these lines from line 2 on.
std::string fragmentMessages(const std::string& lines, const test::Files& more = {}) {
  test::Files files = {{"/a.vsh", kLegacyVertex}, {"/a.fsh", "#version 120\n" + lines}};
  files.insert(more.begin(), more.end());
  return validated(files, {"/a.vsh", "/a.fsh"});
}

TEST(validate, a_missing_semicolon_is_reported_where_it_is_missing) {
  EXPECT_EQ(
      fragmentMessages("void main() {\n  float a = 1.0\n\n  // why\n  float b = a;\n}\n"),
      "/a.fsh:3:16: error: syntax error: expected ';' after '1.0'\n"
      "    float a = 1.0\n"
      "                 ^\n");
}

TEST(validate, a_semicolon_missing_at_the_end_of_an_include_is_reported_there) {
  EXPECT_EQ(
      fragmentMessages("#include \"/b.glsl\"\nvoid main() {}\n", {{"/b.glsl", "\nfloat b\n"}}),
      "/b.glsl:2:8: error: syntax error: expected ';' after 'b'\n"
      "  included from /a.fsh:2\n"
      "  float b\n"
      "         ^\n");
}

TEST(validate, a_function_without_its_opening_parenthesis_is_a_message) {
  const std::string text = fragmentMessages("void main) {\n}\n");
  EXPECT_EQ(text.substr(0, text.find('\n')),
            "/a.fsh:2:6: error: 'main' : illegal use of type 'void'");
}

TEST(validate, a_statement_after_the_head_of_an_if_misses_nothing_before_it) {
  const std::string text = fragmentMessages("void main() {\n  if (true)\n    return 1 2;\n}\n");
  EXPECT_EQ(text.substr(0, text.find(':', 7)), "/a.fsh:4");
}

const std::string kLater = "float later() {\n  return 1.0;\n}\nvoid main() { later(); }\n";

TEST(validate, a_missing_closing_brace_is_found_by_indentation) {
  EXPECT_EQ(fragmentMessages("float f(float x) {\n"
                             "  if (x > 0.0) {\n"
                             "    x = 1.0;\n"
                             "\n"
                             "  return x;\n"
                             "}\n" +
                             kLater),
            "/a.fsh:4:13: error: expected '}' after ';': nothing closes the '{' at /a.fsh:3\n"
            "      x = 1.0;\n"
            "              ^\n");
}

TEST(validate, a_missing_opening_brace_is_found_by_indentation) {
  EXPECT_EQ(fragmentMessages("float f(float x) {\n"
                             "  for (int i = 0; i < 3; ++i)\n"
                             "    x = 1.0;\n"
                             "    x += 1.0;\n"
                             "  }\n"
                             "  return x;\n"
                             "}\n" +
                             kLater),
            "/a.fsh:3:30: error: expected '{' after ')': nothing opens the '}' at /a.fsh:6\n"
            "    for (int i = 0; i < 3; ++i)\n"
            "                               ^\n");
}

TEST(validate, a_closing_brace_too_many_is_where_the_function_goes_on_behind_it) {
  const auto placeIn = [](const std::string& body) {
    const std::string text = fragmentMessages(body + kLater);
    return text.substr(0, text.find('\n'));
  };
  const std::string tooMany = ": error: '}' without '{': nothing opens what it would close";
  EXPECT_EQ(placeIn("float f(float x) {\n  x += 1.0;\n}\n  if (x > 0.0)\n    x = 1.0;\n"
                    "  if (x > 1.0) {\n    x = 2.0;\n  }\n  return x;\n}\n"),
            "/a.fsh:4:1" + tooMany);
  EXPECT_EQ(placeIn("float f(float x) {\n  if (x > 0.0)\n    x = 1.0;\n  return x;\n}\n}\n"),
            "/a.fsh:7:1" + tooMany);
  // The layout asks for the '{' of the if.
  EXPECT_EQ(placeIn("float f(float x) {\n  if (x > 0.0)\n    x = 1.0;\n    x = 3.0;\n  }\n"
                    "  return x;\n}\n"),
            "/a.fsh:3:15: error: expected '{' after ')': nothing opens the '}' at /a.fsh:6");
}

TEST(validate, a_brace_is_missing_before_an_else_that_stands_below_its_if) {
  EXPECT_EQ(fragmentMessages("float f(float x) {\n"
                             "  if (x > 0.0) {\n"
                             "    x = 1.0;\n"
                             "  else {\n"
                             "    if (x > 1.0) x = 2.0;\n"
                             "    else x = 3.0;\n"
                             "  }\n"
                             "  return x;\n"
                             "}\n" +
                             kLater),
            "/a.fsh:5:3: error: expected '}' after ';': nothing closes the '{' at /a.fsh:3\n"
            "    else {\n"
            "    ^\n");
}

TEST(validate, a_brace_is_missing_amid_many_blank_lines) {
  EXPECT_EQ(fragmentMessages("float f(float x) {\n"
                             "  return x;\n"
                             "\n"
                             "\n"
                             "\n"
                             "\n" +
                             kLater),
            "/a.fsh:5:1: error: expected '}' after ';': nothing closes the '{' at /a.fsh:2\n");
}

TEST(validate, blocks_that_are_indented_oddly_are_no_missing_brace) {
  EXPECT_EQ(fragmentMessages("float f(float x) {\n"
                             "    if (x > 0.0) {\n"
                             "    x = 1.0;\n"
                             "  }\n"
                             "  if (x > 1.0)\n"
                             "    x = 2.0;\n"
                             "    x += 1.0;\n"
                             "  }\n"
                             "  return x;\n"
                             "}\n" +
                             kLater),
            "/a.fsh:6:15: error: expected '{' after ')': nothing opens the '}' at /a.fsh:9\n"
            "    if (x > 1.0)\n"
            "                ^\n");
}

TEST(validate, an_else_cannot_follow_an_else) {
  EXPECT_EQ(fragmentMessages("float f(float x) {\n"
                             "  if (x > 0.0) {\n"
                             "  if (x > 1.0) {\n"
                             "    x = 1.0;\n"
                             "  } else {\n"
                             "    x = 2.0;\n"
                             "  } else {\n"
                             "    x = 3.0;\n"
                             "  }\n"
                             "  return x;\n"
                             "}\n" +
                             kLater),
            "/a.fsh:7:13: error: expected '}' after ';': nothing closes the '{' at /a.fsh:6\n"
            "      x = 2.0;\n"
            "              ^\n");
}

TEST(validate, a_line_does_not_stand_further_out_than_its_block) {
  std::string block;
  for (int i = 0; i < 9; ++i) block += "      x += 0.5;\n";
  EXPECT_EQ(fragmentMessages("float f(float x) {\n"
                             "    if (x > 0.0) {\n" +
                             block +
                             "  x += 1.0;\n"
                             "    if (x > 2.0) {\n"
                             "      x = 3.0;\n"
                             "    }\n"
                             "  return x;\n"
                             "}\n" +
                             kLater),
            "/a.fsh:12:16: error: expected '}' after ';': nothing closes the '{' at /a.fsh:3\n"
            "        x += 0.5;\n"
            "                 ^\n");
}

TEST(validate, what_is_left_of_a_function_is_not_outside_it) {
  EXPECT_EQ(fragmentMessages("float f(float x) {\n"
                             "  x += 1.0;\n"
                             "if (x > 0.0) {\n"
                             "  x = 1.0;\n"
                             "} else {\n"
                             "  x = 3.0;\n"
                             "}\n" +
                             kLater),
            "/a.fsh:8:2: error: expected '}' after '}': nothing closes the '{' at /a.fsh:2\n"
            "  }\n"
            "   ^\n");
}

TEST(validate, a_line_left_blank_tells_where_its_brace_was) {
  EXPECT_EQ(fragmentMessages("float f(float x) {\n"
                             "  if (x > 0.0) {\n"
                             "    x = 1.0;\n"
                             "\n"
                             "  \n"
                             "  return x;\n"
                             "}\n" +
                             kLater),
            "/a.fsh:6:3: error: expected '}' after ';': nothing closes the '{' at /a.fsh:3\n"
            "    \n"
            "    ^\n");
}

// The brace above the else is whole; the else lacks its own.
TEST(validate, an_else_belongs_to_the_brace_that_is_missing_before_it) {
  EXPECT_THAT(fragmentMessages("float f(float x) {\n"  // 2
                               "  if (x > 0.0) {\n"    // 3
                               "    if (x > 1.0) {\n"  // 4
                               "      x = 1.0;\n"      // 5
                               "    } else {\n"        // 6
                               "      x = 2.0;\n"      // 7
                               "    }\n"               // 8
                               "\n"                    // 9
                               "   else {\n"           // 10
                               "    x = 3.0;\n"        // 11
                               "  }\n"
                               "  return x;\n"
                               "}\n" +
                               kLater),
              StartsWith("/a.fsh:10:4: error: expected '}' after '}': nothing closes the '{' at "
                         "/a.fsh:3\n"));
}

TEST(validate, an_else_below_its_brace_lacks_none) {
  EXPECT_THAT(fragmentMessages("float f(float x) {\n"         // 2
                               "  if (x > 0.0) {\n"           // 3
                               "    if (x > 1.0) {\n"         // 4
                               "      x = 1.0;\n"             // 5
                               "    } else if (x > 2.0) {\n"  // 6
                               "      x = 2.0;\n"             // 7
                               "\n\n"                         // 8, 9
                               "    x += 1.0;\n"              // 10
                               "  }\n"                        // 11
                               "  else {\n"                   // 12
                               "    x = 3.0;\n"
                               "  }\n"
                               "  return x;\n"
                               "}\n" +
                               kLater),
              StartsWith("/a.fsh:7:15: error: expected '}' after ';': nothing closes the '{' at "
                         "/a.fsh:6\n"));
}

TEST(validate, a_block_that_holds_an_include_ends_behind_it) {
  EXPECT_THAT(fragmentMessages("float f(float x) {\n"
                               "  if (x > 0.0) {\n"
                               "#include \"/b.glsl\"\n"
                               "  return x;\n"
                               "}\n" +
                                   kLater,
                               {{"/b.glsl", "x = 1.0;\nx += 1.0;\n"}}),
              StartsWith("/a.fsh:4:19: error: expected '}' after ';': nothing closes the '{' at "
                         "/a.fsh:3\n  #include"));
}

// One head of each branch, one block: its end stands below the #if.
TEST(validate, a_head_inside_an_if_is_closed_as_the_if_is_indented) {
  EXPECT_THAT(fragmentMessages("float f(float x) {\n"    // 2
                               "  if (x > 0.0) {\n"      // 3
                               "    #ifdef NEVER\n"      // 4
                               "      if (x > 1.0) {\n"  // 5
                               "    #else\n"             // 6
                               "      if (x > 2.0) {\n"  // 7
                               "    #endif\n"            // 8
                               "      x = 1.0;\n"        // 9
                               "    }\n"                 // 10
                               "    else {\n"            // 11
                               "      x = 2.0;\n"        // 12
                               "    }\n"                 // 13
                               "\n"                      // 14
                               "  return x;\n"
                               "}\n" +
                               kLater),
              StartsWith("/a.fsh:13:6: error: expected '}' after '}': nothing closes the '{' at "
                         "/a.fsh:3\n"));
}

TEST(validate, a_name_behind_an_unknown_type_cannot_stand_there) {
  EXPECT_EQ(fragmentMessages("float random (float2 uv) {\n  return 1.0;\n}\nvoid main() { random(gl_FragCoord.xy); }\n"),
            "/a.fsh:2:22: error: syntax error: expected ')' before 'uv'\n"
            "  float random (float2 uv) {\n"
            "                       ^\n");
}

TEST(validate, the_line_that_lacks_a_parenthesis_is_reported_and_not_the_end_of_its_statement) {
  EXPECT_EQ(
      fragmentMessages("float f(float x) {\n"
                       "  return (x + 1.0) *\n"
                       "         (x + 2.0 *\n"
                       "         (x + 3.0) *\n"
                       "         (x + 4.0);\n"
                       "}\n"
                       "void main() { f(1.0); }\n"),
      "/a.fsh:4:10: error: syntax error: expected ')' before ';'\n"
      "           (x + 2.0 *\n"
      "           ^\n"
      "  hint: no ')' of this line closes it\n");
}

TEST(validate, a_condition_goes_on_below_its_head) {
  EXPECT_THAT(fragmentMessages("float f(float x) {\n"
                               "  if(x > 1.0\n"
                               "  || x > 2.0\n"
                               "  || x > 3.0 {\n"
                               "    return 1.0;\n"
                               "  }\n"
                               "  return x;\n"
                               "}\n"
                               "void main() { f(1.0); }\n"),
              StartsWith("/a.fsh:5:"));
}

TEST(validate, an_entry_of_a_list_lacks_its_parenthesis) {
  EXPECT_THAT(fragmentMessages("const vec3 list[2] = vec3[2](\n"
                               "  vec3(1.0, 0.0, 0.0,\n"
                               "  vec3(0.0));\n" +
                               kLater),
              testing::HasSubstr("/a.fsh:3:7: error: 'constructor' : too many arguments\n"
                                 "    vec3(1.0, 0.0, 0.0,\n"
                                 "        ^\n"
                                 "  hint: no ')' of this line closes it\n"));
}

TEST(validate, the_end_of_a_function_without_brace_is_before_the_next_function) {
  EXPECT_EQ(fragmentMessages("float f(float x) {\n  return x;\n\n" + kLater),
            "/a.fsh:3:12: error: expected '}' after ';': nothing closes the '{' at /a.fsh:2\n"
            "    return x;\n"
            "             ^\n");
}

TEST(validate, link_errors_stand_at_the_entry_file_of_their_stage) {
  EXPECT_EQ(validated({{"/a.vsh", kLegacyVertex},
                       {"/a.fsh", "#version 120\nvoid notMain() {}\nfloat f();\nfloat a = f();\n"}},
                      {"/a.vsh", "/a.fsh"})
                .substr(0, 15),
            "/a.fsh: error: ");
}

TEST(validate, built_in_varyings_written_by_hand_are_no_clash) {
  EXPECT_EQ(
      validated(
          {{"/a.vsh",
            "#version 120\nvoid main() { gl_Position = ftransform(); gl_FogFragCoord = 1.0;"
            " gl_TexCoord[0] = gl_MultiTexCoord0; }\n"},
           {"/a.fsh",
            "#version 120\nvoid main() { gl_FragColor = gl_TexCoord[0] * gl_FogFragCoord; }\n"}},
          {"/a.vsh", "/a.fsh"}),
      "");
}

TEST(validate, an_extension_unknown_to_glslang_is_only_a_warning) {
  const std::string text = validated(
      {{"/a.vsh", kLegacyVertex},
       {"/a.fsh", "#version 120\n#extension GL_NV_unheard_of : require\nvoid main() {}\n"}},
      {"/a.vsh", "/a.fsh"});
  EXPECT_EQ(text.substr(0, text.find('\n')),
            "/a.fsh:2:1: warning: '#extension' : extension not supported: GL_NV_unheard_of");
}

TEST(validate, compute_programs_are_checked) {
  const test::Files files = {
      {"/a.csh",
       "#version 430\nlayout(local_size_x = 8, local_size_y = 8) in;\n"
       "layout(rgba16f) uniform image2D colorimg0;\n"
       "void main() { imageStore(colorimg0, ivec2(gl_GlobalInvocationID.xy), vec4(x)); }\n"}};
  EXPECT_EQ(validated(files, {"/a.csh"}).substr(0, 55),
            "/a.csh:4:75: error: 'x' : undeclared identifier\n  void ");
}

TEST(validate, works_from_several_threads) {
  std::vector<std::string> results(4);
  std::vector<std::thread> threads;
  for (std::string& result : results) {
    threads.emplace_back([&result] {
      result = validated({{"/a.vsh", kLegacyVertex},
                          {"/a.fsh", "#version 120\nvoid main() { gl_FragColor = vec4(y); }\n"}},
                         {"/a.vsh", "/a.fsh"});
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const std::string& result : results) {
    EXPECT_EQ(result,
              "/a.fsh:2:35: error: 'y' : undeclared identifier\n"
              "  void main() { gl_FragColor = vec4(y); }\n"
              "                                    ^\n");
  }
}

}  // namespace
}  // namespace orris
