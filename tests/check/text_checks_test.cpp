// Includes, directives and shaders.properties as texts.
#include <orris/check/pack/directive_checks.h>
#include <orris/check/pack/include_checks.h>
#include <orris/check/pack/property_checks.h>
#include "pack_fixture.h"

namespace orris {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(UnusedIncludes, a_file_that_no_program_reaches_is_a_note) {
  EXPECT_THAT(
      found(checkUnusedIncludes, {{"/settings.glsl", "#include \"lib/a.glsl\"\n"},
                                  {"/lib/a.glsl", ""},
                                  {"/lib/b.glsl", ""},
                                  {"/program/c.fsh", ""},
                                  {"/readme.txt", ""}}),
      ElementsAre("include-unused /lib/b.glsl:0:0: note: no program includes this file",
                  "include-unused /program/c.fsh:0:0: note: no program includes this file"));
}

TEST(UnusedIncludes, programs_of_mods_and_other_hosts_include_too) {
  for (const char* file : {"/dh_terrain.fsh", "/world1/dh_water.vsh", "/voxy_opaque.glsl",
                           "/clrwl_gbuffers.fsh", "/composite200.fsh"}) {
    EXPECT_THAT(
        found(checkUnusedIncludes, {{file, "#include \"/lib/a.glsl\"\n"}, {"/lib/a.glsl", ""}}),
        IsEmpty())
        << file;
  }
  EXPECT_THAT(found(checkUnusedIncludes, {{"/photonics/light.glsl", ""}}), IsEmpty());
}

TEST(DirectiveNames, a_misspelt_constant_that_nothing_uses_is_a_warning) {
  EXPECT_THAT(found(checkDirectiveNames, {{"/settings.glsl",
                                           "/*\nconst int colortex1Fromat = RGBA16F;\n*/\n"
                                           "  const bool coloretx5MipmapEnabled = true;\n"
                                           "const int shadowMapResoluton = 1024;\n"}}),
              ElementsAre("directive-misspelt /settings.glsl:4:14: warning: nothing reads "
                          "coloretx5MipmapEnabled, which is no directive | did you mean "
                          "colortex5MipmapEnabled?",
                          "directive-misspelt /settings.glsl:2:11: warning: nothing reads "
                          "colortex1Fromat, which is no directive | did you mean colortex1Format?",
                          "directive-misspelt /settings.glsl:5:11: warning: nothing reads "
                          "shadowMapResoluton, which is no directive | did you mean "
                          "shadowMapResolution?"));
}

TEST(DirectiveNames, a_digit_may_stand_before_the_letter_it_belongs_behind) {
  EXPECT_THAT(
      found(checkDirectiveNames,
            {{"/settings.glsl",
              "const bool colorte1x3Clear = false;\nconst int colortex55Format = RGBA8;\n"}}),
      ElementsAre("directive-misspelt /settings.glsl:1:12: warning: nothing reads "
                  "colorte1x3Clear, which is no directive | did you mean "
                  "colortex13Clear?"));
}

TEST(DirectiveNames, the_constants_of_a_shader_and_of_larger_hosts_are_quiet) {
  EXPECT_THAT(
      found(checkDirectiveNames,
            {{"/settings.glsl",
              "const float shadowDistances = 3.0;\nfloat f = shadowDistances;\n"
              "const int colortex17Format = RGBA16F;\nconst float pi = 3.14;\n"
              "const float rShadowMapResolution = 1.0 / float(shadowMapResolution);\n"
              "// const int colortex1Fromat = RGBA16F;\nconst bool gaux4Clear = false;\n"}}),
      IsEmpty());
}

TEST(DirectiveNames, misspelt_comments_are_warnings) {
  EXPECT_THAT(
      found(checkDirectiveNames, {{"/settings.glsl",
                                   "  /* RENDERTAGETS: 0,3 */\n"
                                   "/* RENDERTARGETS: 0 */\n"
                                   "/* DRAWBUFERS:03 */\n"
                                   "/* NOTE: 3 */\n"}}),
      ElementsAre("directive-misspelt /settings.glsl:1:6: warning: nothing reads RENDERTAGETS, "
                  "which is no directive | did you mean RENDERTARGETS?",
                  "directive-misspelt /settings.glsl:3:4: warning: nothing reads DRAWBUFERS, "
                  "which is no directive | did you mean DRAWBUFFERS?"));
}

std::vector<std::string> properties(const std::string& text) {
  return found(checkPropertiesTwice, {{"/shaders.properties", text}});
}

TEST(PropertiesTwice, the_earlier_value_is_lost) {
  EXPECT_THAT(properties("sun=true\nmoon=false\nsun = false\nmoon = false\n"),
              ElementsAre("property-twice /shaders.properties:3:1: warning: sun is given again, so "
                          "its value in line 1 is lost | the last line of a key counts"));
}

TEST(PropertiesTwice, the_line_that_is_lost_is_a_place_of_the_finding) {
  const ShaderPack pack = loadPackWith({{"/shaders.properties", "clouds=fancy\nmoon=true\nclouds=fast\n"}});
  Diagnostics diagnostics;
  checkPropertiesTwice(std::span(&pack, 1), diagnostics);
  ASSERT_EQ(diagnostics.size(), 1u);
  ASSERT_EQ(diagnostics.front().related.size(), 1u);
  EXPECT_EQ(formatLocation(diagnostics.front().related.front().at), "/shaders.properties:1:1");
}

TEST(PropertiesTwice, branches_tell_values_apart) {
  EXPECT_THAT(properties("#ifdef A\nsun=true\n#else\nsun=false\n#endif\n"), IsEmpty());
  EXPECT_THAT(properties("sun=true\n#ifdef MC_VERSION\nsun=false\n#endif\n"), IsEmpty());
  EXPECT_THAT(properties("notes=1\nnotes=2\n"), IsEmpty()) << "nobody reads it";
  EXPECT_THAT(properties("#ifdef MC_VERSION\nsun=true\n#endif\nsun=false\n"), testing::SizeIs(1));
}

TEST(StrayLines, follow_a_list_without_a_backslash) {
  const auto stray = [](const std::string& text) {
    return found(checkStrayLines,
                 {{"/settings.glsl", "#define A 1 // [1 2]\n#define B 1 // [1 2]\n"},
                  {"/shaders.properties", text}});
  };
  EXPECT_THAT(stray("screen = A \\\n  B\n  A B\n  [WATER]\nsun = false\n"),
              ElementsAre("property-stray-line /shaders.properties:3:3: warning: this line is no "
                          "part of screen: the line before it does not end in a backslash; Iris "
                          "ignores this line | end the line before it with a backslash",
                          testing::StartsWith("property-stray-line /shaders.properties:4:3: ")));
  EXPECT_THAT(stray("profile.LOW = A=1\n  B=2\nprogram.x.enabled=A\n"), testing::SizeIs(1));
  EXPECT_THAT(stray("uniform.float.x = if(a == 1, 2.0, \\\n a == 2, 3.0,\n  4.0)\nsun = false\n"),
              ElementsAre(testing::StartsWith("property-stray-line /shaders.properties:3:3: ")));
  EXPECT_THAT(stray("uniform.float.x = if(a, 2.0, 3.0)\nuniform.float.y = x\n"), IsEmpty());
  EXPECT_THAT(stray("screen = A\nsun = false\nscreen.X = B\n\nA = 2\nsliders = A B\n"), IsEmpty());
}

TEST(PropertiesTwice, lines_that_are_meant_as_comments_are_reported_once) {
  const std::string text = "// sun=true\nmoon=true\n// sun = false\n//scale.composite1 = 0.5\n";
  EXPECT_THAT(properties(text), IsEmpty());
  EXPECT_THAT(found(checkStrayLines, {{"/shaders.properties", text}}),
              ElementsAre("property-comment /shaders.properties:1:1: note: 3 lines begin with //, "
                          "which is a key that nothing reads, and no comment | # begins a comment"));
}

TEST(PropertiesTwice, screens_and_profiles_know_no_branches) {
  EXPECT_THAT(
      properties("#ifdef A\nscreen=X\n#else\nscreen=Y\n#endif\n"),
      ElementsAre("property-twice /shaders.properties:4:1: warning: screen is given again, so "
                  "its value in line 2 is lost | for this key #if lines count for nothing: of "
                  "all lines the last one counts"));
}

}  // namespace
}  // namespace orris
