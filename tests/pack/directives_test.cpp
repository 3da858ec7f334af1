#include <orris/pack/programs/directives.h>

#include <gmock/gmock.h>

#include <orris/glsl/preprocess/preprocessor.h>

namespace orris {
namespace {

using testing::ElementsAre;

TokenStream streamOf(const std::string& text, Diagnostics& diagnostics) {
  FlatSource flat{{{"/a.fsh"}}, {{"#version 330", 0, 0}}, nullptr};
  for (size_t begin = 0; begin < text.size();) {
    const size_t end = std::min(text.find('\n', begin), text.size());
    flat.own(text.substr(begin, end - begin), 0, static_cast<int>(flat.lines.size()));
    begin = end + 1;
  }
  return preprocess(flat, {}, diagnostics);
}

std::optional<std::vector<int>> buffers(const std::string& text, std::string* error = nullptr) {
  Diagnostics diagnostics;
  const auto directives =
      readProgramDirectives(streamOf(text, diagnostics), kColorTargets, diagnostics);
  if (error) *error = diagnostics.empty() ? "" : formatDiagnostic(diagnostics[0]);
  return directives.drawBuffers;
}

PackDirectives packOf(const std::string& text) {
  Diagnostics diagnostics;
  const TokenStream stream = streamOf(text, diagnostics);
  PackDirectives directives;
  readPackDirectives(findConstLines(stream), stream.sites, directives, diagnostics);
  EXPECT_TRUE(diagnostics.empty()) << formatDiagnostic(diagnostics[0]);
  return directives;
}

TEST(ProgramDirectives, both_forms_name_buffers) {
  EXPECT_THAT(*buffers("/* RENDERTARGETS: 0,3,12 */"), ElementsAre(0, 3, 12));
  EXPECT_THAT(*buffers("/*RENDERTARGETS:\t7,1,\n*/"), ElementsAre(7, 1));
  EXPECT_THAT(*buffers("/*DRAWBUFFERS:0257*/"), ElementsAre(0, 2, 5, 7));
  EXPECT_EQ(buffers("void main() {}"), std::nullopt);
}

TEST(ProgramDirectives, the_last_one_wins) {
  EXPECT_THAT(*buffers("/* RENDERTARGETS: 0 */\n/* RENDERTARGETS: 1 */"), ElementsAre(1));
  EXPECT_THAT(*buffers("/* RENDERTARGETS: 0 */\n/* DRAWBUFFERS:2 */"), ElementsAre(2));
  EXPECT_THAT(*buffers("/* DRAWBUFFERS:2 */\n/* RENDERTARGETS: 0 */"), ElementsAre(0));
}

TEST(ProgramDirectives, what_iris_refuses_the_pack_for) {
  for (const char* list : {"0, 1", "0 ,1", "0,\t1", "0,,1", "0,x", "", "0 1", ",1"}) {
    Diagnostics diagnostics;
    const auto directives = readProgramDirectives(
        streamOf("/* RENDERTARGETS: " + std::string(list) + " */", diagnostics), kColorTargets,
        diagnostics);
    EXPECT_EQ(directives.drawBuffers, std::nullopt) << list;
    EXPECT_TRUE(refusesPack(diagnostics)) << list;
  }
}

TEST(ProgramDirectives, inactive_branches_do_not_count) {
  EXPECT_THAT(*buffers("/* RENDERTARGETS: 0 */\n#ifdef X\n/* RENDERTARGETS: 1 */\n#endif"),
              ElementsAre(0));
}

TEST(ProgramDirectives, a_keyword_that_does_not_open_its_comment_voids_the_earlier_ones) {
  EXPECT_EQ(buffers("/* RENDERTARGETS: 0 */\n// RENDERTARGETS: 1"), std::nullopt);
  EXPECT_EQ(buffers("/* use RENDERTARGETS: 0 */"), std::nullopt);
  EXPECT_EQ(buffers("/* RENDERTARGETS : 0 */"), std::nullopt);
}

TEST(ProgramDirectives, indices_beyond_the_host_are_errors) {
  std::string error;
  EXPECT_EQ(buffers("\n/* RENDERTARGETS: 16,31 */", &error), (std::vector{16, 31}));
  EXPECT_EQ(buffers("\n/* RENDERTARGETS: 0,32 */", &error), std::nullopt);
  EXPECT_EQ(error,
            "/a.fsh:2:1: error: buffer 32 does not exist: the last one is 31\n"
            "  /* RENDERTARGETS: 0,32 */\n  ^");
  buffers("/* RENDERTARGETS: 0,1,2,3,4,5,6,7,8 */", &error);
  EXPECT_THAT(error, testing::HasSubstr("9 buffers are listed, at most 8 can be drawn at once"));
}

TEST(ProgramDirectives, mipmaps_and_work_groups) {
  Diagnostics diagnostics;
  const TokenStream stream = streamOf(
      "const bool colortex4MipmapEnabled = true;\nconst bool gaux2MipmapEnabled = true;\n"
      "const bool colortex4MipmapEnabled = false;\nconst ivec3 workGroups = ivec3(8, 4, 1);\n"
      "const vec2 workGroupsRender = vec2(0.5f, 1.0);",
      diagnostics);
  const ProgramDirectives directives = readProgramDirectives(stream, kColorTargets, diagnostics);
  EXPECT_THAT(directives.mipmaps, ElementsAre(5));
  EXPECT_EQ(directives.workGroups, (std::array{8, 4, 1}));
  EXPECT_EQ(directives.workGroupsRender, (std::array{0.5f, 1.0f}));
}

TEST(PackDirectives, are_read_from_code_and_from_block_comments) {
  const PackDirectives directives = packOf(
      "/*\nconst int colortex3Format = rgba16f; text\n const int gaux1Format = R8;\n*/\n"
      "  const bool colortex3Clear = false;\nconst vec4 shadowcolor1ClearColor = vec4(0.0, 1.0, "
      ".5, 1);\n"
      "const int shadowMapResolution = 2048;");
  EXPECT_EQ(directives.colortex.at(3).format, "RGBA16F");
  EXPECT_FALSE(directives.colortex.at(3).clear);
  EXPECT_EQ(directives.colortex.at(4).format, "R8");
  EXPECT_EQ(directives.shadowcolor.at(1).clearColor, (std::array{0.0f, 1.0f, 0.5f, 1.0f}));
  EXPECT_EQ(directives.shadowMapResolution, 2048);
}

TEST(PackDirectives, macros_are_expanded) {
  EXPECT_FLOAT_EQ(
      packOf("#define DISTANCE 96.0\nconst float shadowDistance = DISTANCE;").shadowDistance, 96);
  EXPECT_FLOAT_EQ(packOf("const float sunPathRotation = -40.0;").sunPathRotation, -40);
}

TEST(PackDirectives, what_is_no_directive) {
  const PackDirectives directives = packOf(
      "// const float shadowDistance = 1.0;\nint x; const float shadowDistance = 2.0;\n"
      "const int shadowDistance = 3;\n/* const float shadowDistance = 4.0; */\nconst float "
      "shadowDistance\n= 5.0;\n"
      "const int colortex38Format = RGBA99;");
  EXPECT_FLOAT_EQ(directives.shadowDistance, 160);
  EXPECT_TRUE(directives.colortex.empty());
}

/// What readPackDirectives() or readProgramDirectives() says of one const line.
struct ConstCase {
  const char* line;
  Effect effect;
};

TEST(PackDirectives, vectors_are_read_as_iris_reads_them) {
  const ConstCase kCases[] = {
      {"const vec4 colortex0ClearColor = vec4(0.0, 0.0, 0.0, 1.0);", Effect::Unstated},
      {"const vec4 colortex0ClearColor = vec4(0, 1d, .5f, 1, 7);", Effect::Unstated},
      {"const vec4 colortex0ClearColor = vec4(0.0);", Effect::RefusesPack},
      {"const vec4 colortex0ClearColor = vec4(0.0, 0.0, 0.0);", Effect::RefusesPack},
      {"const vec4 colortex0ClearColor = RED;", Effect::RefusesPack},
      {"const vec4 colortex0ClearColor = vec4;", Effect::RefusesPack},
      {"const vec4 colortex0ClearColor = vec4();", Effect::IgnoresLine},
      {"const vec4 colortex0ClearColor = vec4(vec3(0.0), 1.0);", Effect::IgnoresLine},
      {"const float sunPathRotation = 20.0 * 2.0;", Effect::IgnoresLine},
  };
  for (const ConstCase& test : kCases) {
    Diagnostics diagnostics;
    const TokenStream stream = streamOf(test.line, diagnostics);
    PackDirectives directives;
    readPackDirectives(findConstLines(stream), stream.sites, directives, diagnostics);
    EXPECT_EQ(diagnostics.empty() ? Effect::Unstated : diagnostics[0].effect, test.effect)
        << test.line;
  }
}

TEST(ProgramDirectives, work_groups_are_read_as_iris_reads_them) {
  const ConstCase kCases[] = {
      {"const ivec3 workGroups = ivec3(8, 4, 1);", Effect::Unstated},
      {"const ivec3 workGroups = ivec3(8);", Effect::RefusesPack},
      {"const ivec3 workGroups = ivec3(8.0, 4, 1);", Effect::IgnoresLine},
      {"const vec2 workGroupsRender = vec2(0.5);", Effect::RefusesPack},
  };
  for (const ConstCase& test : kCases) {
    Diagnostics diagnostics;
    readProgramDirectives(streamOf(test.line, diagnostics), kColorTargets, diagnostics);
    EXPECT_EQ(diagnostics.empty() ? Effect::Unstated : diagnostics[0].effect, test.effect)
        << test.line;
  }
}

TEST(ProgramDirectives, more_work_groups_than_gl_promises_are_a_warning) {
  for (const char* groups : {"ivec3(65535, 1, 1)", "ivec3(65535, 65535, 1)"}) {
    Diagnostics diagnostics;
    readProgramDirectives(streamOf("const ivec3 workGroups = " + std::string(groups) + ";", diagnostics), kColorTargets,
                          diagnostics);
    EXPECT_TRUE(diagnostics.empty()) << groups;
  }
  for (const char* groups : {"ivec3(1, 65536, 1)", "ivec3(65535, 65535, 2)"}) {
    Diagnostics diagnostics;
    readProgramDirectives(streamOf("const ivec3 workGroups = " + std::string(groups) + ";", diagnostics), kColorTargets,
                          diagnostics);
    ASSERT_EQ(diagnostics.size(), 1u);
    EXPECT_EQ(diagnostics[0].severity, Severity::Warning);
    EXPECT_EQ(diagnostics[0].message, "workGroups is " + std::string(groups));
  }
}

TEST(PackDirectives, booleans_are_words) {
  EXPECT_TRUE(packOf("const bool colortex3Clear = 0;").colortex.at(3).clear);
  EXPECT_FALSE(packOf("const bool colortex3Clear = false;").colortex.at(3).clear);
}

// Iris: PackDirectives.acceptDirectivesFrom.
TEST(PackDirectives, dryness_sets_the_half_life_of_wetness) {
  Diagnostics diagnostics;
  const TokenStream stream = streamOf(
      "const float wetnessHalflife = 100.0;\nconst float drynessHalflife = 260.0;", diagnostics);
  PackDirectives directives;
  readPackDirectives(findConstLines(stream), stream.sites, directives, diagnostics);
  EXPECT_FLOAT_EQ(directives.wetnessHalflife, 260);
  EXPECT_FLOAT_EQ(directives.drynessHalflife, 200);
  ASSERT_EQ(diagnostics.size(), 1u);
  EXPECT_EQ(diagnostics[0].id, "directive-slip");
  EXPECT_EQ(diagnostics[0].message,
            "Iris sets the wetness half-life by drynessHalflife, and dryness keeps 200");
}

TEST(PackDirectives, switches_of_both_shadow_maps) {
  const PackDirectives directives = packOf(
      "const bool shadowHardwareFiltering = true;\nconst bool shadowHardwareFiltering1 = false;\n"
      "const bool shadow1MinMagNearest = true;\nconst bool generateShadowMipmap = true;");
  EXPECT_TRUE(directives.shadowtex[0].hardwareFiltering);
  EXPECT_FALSE(directives.shadowtex[1].hardwareFiltering);
  EXPECT_FALSE(directives.shadowtex[0].nearest);
  EXPECT_TRUE(directives.shadowtex[1].nearest);
  EXPECT_TRUE(directives.shadowtex[1].mipmap);
}

TEST(PackDirectives, ambient_occlusion_is_clamped) {
  EXPECT_FLOAT_EQ(packOf("const float ambientOcclusionLevel = 3.0;").ambientOcclusionLevel, 1);
}

}  // namespace
}  // namespace orris
