#include <orris/check/hints/conditional_place.h>

#include <gmock/gmock.h>

#include <orris/core/files/file_source.h>
#include <orris/pack/shader_pack.h>
#include "text_fixture.h"

namespace orris {
namespace {

using ::testing::AllOf;
using ::testing::AnyOf;
using ::testing::Contains;
using ::testing::Each;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

/// "line: message" of what is reported of conditionals in `file`, over all folders.
Lines reported(const Files& files, const std::vector<std::string>& dimensions, bool settle,
               std::size_t* made = nullptr) {
  std::vector<ShaderPack> folders;
  std::vector<Diagnostics> found;
  for (const std::string& dimension : dimensions) {
    LoadRequest request{.environment = standardMacros({})};
    request.dimension = dimension;
    request.keepGoing = true;
    folders.push_back(*loadShaderPack(memorySource(files), request, found.emplace_back()));
  }
  TrialMemo trials;
  if (settle) settleConditionals(folders, 1, trials, found);
  if (made) *made = trials.made();
  Lines lines;
  for (const Diagnostics& diagnostics : found) {
    for (const Diagnostic& d : diagnostics) {
      if (d.id != "conditional-unbalanced") continue;
      lines.push_back(d.at.file + ":" + std::to_string(d.at.line) + ": " + d.message);
      for (const RelatedPlace& place : d.related)
        lines.push_back(place.at.file + ":" + std::to_string(place.at.line) + ": " + place.message);
    }
  }
  return lines;
}

std::string copiesOf(const std::string& line, int count) {
  std::string lines;
  for (int i = 0; i < count; ++i) lines += line + "\n";
  return lines;
}

/// An #endif is missing in line 18, where the first branch ends; a block of two paragraphs follows,
/// and if that ended after the first of them, the lengths of blocks would fit better.
std::string lacksEndif(const std::string& head) {
  return kVersion + head +                                           // 2
         "void main() {\nfloat light = 1.0;\nfloat bright = 0.5;\n"  // 3 to 5
         "#ifdef DARK\n" +
         copiesOf("light *= 0.9;", 10) +  // 6 to 16
         "bright = light;\n\n"           // 17, 18
         "float glow = bright;\n\n"      // 19, 20
         "#ifdef FOG\nbright *= 0.5;\n\n" +
         copiesOf("glow *= 0.7;", 8) +
         "#endif\n"  // 21 to 32
         "gl_FragColor = vec4(glow);\n}\n";
}

TEST(ConditionalPlace, an_endif_stands_where_the_program_compiles) {
  const Files files{{"/composite.vsh", kVertexStage}, {"/composite.fsh", lacksEndif("\n")}};
  EXPECT_THAT(reported(files, {"/"}, false),
              Contains("/composite.fsh:22: expected #endif after this line: nothing closes the "
                       "#ifdef in line 21"));
  EXPECT_THAT(reported(files, {"/"}, true),
              AllOf(Contains("/composite.fsh:17: expected #endif after this line: nothing closes "
                             "the #ifdef in line 6"),
                    Contains("/composite.fsh:6: the #ifdef without #endif"),
                    Not(Contains(HasSubstr(":22:")))));
}

// One of two programs has a mistake of its own.
TEST(ConditionalPlace, of_places_with_which_not_all_compile_the_one_with_the_fewest_errors) {
  const std::string body = lacksEndif("\n");
  const std::string include = "#include \"/lib.glsl\"\n";
  const Files files{{"/composite.vsh", kVertexStage},
                    {"/composite.fsh", kVersion + "vec4 mistake = unknown;\n" + include},
                    {"/composite1.vsh", kVertexStage},
                    {"/composite1.fsh", kVersion + include},
                    {"/lib.glsl", body.substr(body.find("void main"))}};
  EXPECT_THAT(reported(files, {"/"}, true),
              Contains("/lib.glsl:15: expected #endif after this line: nothing closes the #ifdef "
                       "in line 4"));
}

// In one of the folders all of it is read, whatever the place.
TEST(ConditionalPlace, one_place_is_tried_for_all_folders) {
  const std::string body = lacksEndif("\n");
  const std::string shared = body.substr(body.find("void main"));
  const Files files{
      {"/world0/composite.vsh", kVertexStage},
      {"/world0/composite.fsh", kVersion + "#include \"/lib.glsl\"\n"},
      {"/world1/composite.vsh", kVertexStage},
      {"/world1/composite.fsh", kVersion + "#define DARK\n#define FOG\n#include \"/lib.glsl\"\n"},
      {"/lib.glsl", shared}};
  for (const std::vector<std::string>& folders :
       {std::vector<std::string>{"world0", "world1"}, {"world1", "world0"}}) {
    const Lines lines = reported(files, folders, true);
    EXPECT_THAT(lines, Each(AnyOf(StartsWith("/lib.glsl:4:"), StartsWith("/lib.glsl:15:"),
                                  HasSubstr("or nothing closes"))));
  }
}

// What stands in the first branch is no GLSL of this program.
TEST(ConditionalPlace, an_endif_too_many_is_the_one_without_which_the_program_compiles) {
  const std::string fragment = kVersion +
                               "#define GLOW\nvoid main() {\nfloat b = 1.0;\n"  // 2 to 4
                               "#ifndef GLOW\n" +
                               copiesOf("b *= 0.5;", 2) +
                               "\n#endif\n"  // 5 to 9
                               "float glow = unknown;\n" +
                               copiesOf("glow *= 0.7;", 3) +
                               "#else\n"  // to 14
                               "float glow = b;\n" +
                               copiesOf("glow *= 0.7;", 3) +
                               "#endif\n"  // to 19
                               "gl_FragColor = vec4(glow);\n}\n";
  const Files files{{"/composite.vsh", kVertexStage}, {"/composite.fsh", fragment}};
  EXPECT_THAT(reported(files, {"/"}, false), Contains("/composite.fsh:19: #endif without #if"));
  EXPECT_THAT(reported(files, {"/"}, true), Contains("/composite.fsh:9: #endif without #if"));
}

// An #ifdef FSH is missing in line 13; neither always nor never would do for both stages.
TEST(ConditionalPlace, an_if_of_a_stage_is_that_of_the_stage_that_has_none) {
  const std::string both =
      "// 1\n#ifdef VSH\nvoid main() {\n  vec4 p = ftransform();\n"  // to 4
      "  #ifdef SHAKE\n  p.x += 0.1;\n  #endif\n"                    // to 7
      "  gl_Position = p;\n}\n#endif\n\n// a line between\n\n"       // to 13
      "vec4 c = vec4(LIGHT);\n\nconst float d = 1.0;\n\n"            // to 17
      "void main() {\n  gl_FragColor = d * c;\n}\n#endif\n";         // to 21
  const Files files{
      {"/composite.vsh", kVersion + "#define VSH\n#include \"/composite.glsl\"\n"},
      {"/composite.fsh", kVersion + "#define LIGHT 0.5\n#include \"/composite.glsl\"\n"},
      {"/composite.glsl", both}};
  EXPECT_THAT(reported(files, {"/"}, true),
              AllOf(Contains("/composite.glsl:21: #endif without #if"),
                    Contains(AnyOf(
                        StartsWith("/composite.glsl:12: or an #if is missing before this line"),
                        StartsWith("/composite.glsl:14: or an #if is missing before this line")))));
}

TEST(ConditionalPlace, a_slip_and_what_pairs_stay_as_they_are) {
  const Files files{{"/composite.vsh", kVertexStage},
                    {"/composite.fsh", kVersion + "#ifdef A\n#endfi\nvoid main() {}\n"}};
  EXPECT_EQ(reported(files, {"/"}, true), reported(files, {"/"}, false));
}

// Two are missing, so that no place is good, and each is tried with eight conditions.
TEST(ConditionalPlace, trials_of_one_file_are_bounded) {
  std::string lib = "#endif\nfloat light = lost();\n#endif\n";
  for (int i = 0; i < 40; ++i)
    lib += "#ifdef FSH_" + std::to_string(i % 5) + "\nlight *= 0.5;\n\nlight += 0.1;\n\n#endif\n\n";
  const std::string program = kVersion + "#include \"/lib.glsl\"\nvoid main() { gl_FragColor = vec4(light); }\n";
  std::size_t made = 0;
  reported({{"/lib.glsl", lib},
            {"/composite.vsh", kVertexStage},
            {"/composite.fsh", program},
            {"/deferred.vsh", kVertexStage},
            {"/deferred.fsh", program + "\n"}},
           {"/"}, true, &made);
  EXPECT_GT(made, 100u);
  EXPECT_LT(made, 250u);
}

}  // namespace
}  // namespace orris
