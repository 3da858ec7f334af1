#include <orris/check/pack/open_comments.h>

#include <gmock/gmock.h>

#include <orris/pack/files/text.h>
#include "pack_fixture.h"
#include "text_fixture.h"

namespace orris {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// "line>nested:ends" of each comment.
std::vector<std::string> comments(const std::string& text) {
  std::vector<std::string> all;
  for (const OpenComment& comment : findOpenComments(splitLines(text))) {
    std::string line = std::to_string(comment.line) + ">" + std::to_string(comment.nestedLine) + ":";
    for (const int end : comment.ends) line += " " + std::to_string(end);
    all.push_back(line);
  }
  return all;
}

TEST(OpenComments, a_comment_with_another_begin_in_a_later_line) {
  EXPECT_THAT(comments("a\n/* b\nc\n\nd /* e */\n"), ElementsAre("2>5: 3 4 5"));
  EXPECT_THAT(comments("#define A 1 /* [0 1]\n#define B\n/* c */\n"), ElementsAre("1>3: 2 3"));
  EXPECT_THAT(comments("#define A 1 /* [0 1]\n#define B\n"), ElementsAre("1>3: 2 3"));
}

TEST(OpenComments, what_ends_a_comment_or_decorates_it_begins_none) {
  EXPECT_THAT(comments("/* a\n//* b\n*/\n/*\n c /*/\n"), IsEmpty());
  EXPECT_THAT(comments("// /*\n/* a */\n/* a /* b\n*/\n"), IsEmpty());
}

TEST(OpenComments, those_that_swallow_nothing_known_are_warnings_where_a_comment_begins_a_line) {
  EXPECT_THAT(
      found(checkNestedComments, {{"/settings.glsl", "/*\nold /* why */\n"}}),
      ElementsAre("comment-nested /settings.glsl:1:1: note: this comment does not end before the "
                  "\"/*\" in line 2"));
  EXPECT_THAT(
      found(checkNestedComments, {{"/settings.glsl", "/*\nold\n  /* DRAWBUFFERS:0 */\n"}}),
      ElementsAre("comment-nested /settings.glsl:1:1: warning: this comment does not end before the "
                  "\"/*\" in line 3"));
  EXPECT_THAT(found(checkNestedComments, {{"/settings.glsl", "/*\nold\n"}}),
              ElementsAre("comment-nested /settings.glsl:1:1: warning: this comment does not end in "
                          "its file"));
  EXPECT_THAT(found(checkNestedComments,
                    {{"/settings.glsl", "#define A 1 /* [0 1]\nold\n/* why */\n"}}),
              ElementsAre("comment-nested /settings.glsl:1:13: warning: this comment does not end "
                          "before the \"/*\" in line 3"));
}

/// What is reported of a pack of one program whose library is `library`.
Diagnostics swallowed(const std::string& library) {
  Files files{{"/lib.glsl", library},
              {"/composite.vsh", kVertexStage},
              {"/composite.fsh", kVersion + "#include \"/lib.glsl\"\n"
                                            "void main() { gl_FragColor = vec4(shade()); }\n"}};
  Diagnostics diagnostics;
  const auto pack = loadShaderPack(memorySource(files), {.environment = standardMacros({})}, diagnostics);
  Verdicts verdicts;
  checkWithGlslang(*pack, 1, verdicts, diagnostics);
  const auto before = std::ptrdiff_t(diagnostics.size());
  reportSwallowedCode(*pack, verdicts, 1, diagnostics);
  return {diagnostics.begin() + before, diagnostics.end()};
}

TEST(OpenComments, one_without_which_the_program_compiles_is_an_error_with_its_end) {
  const Diagnostics errors =
      swallowed("/* what it does\n   and why\n\nfloat shade() { return 1.0; }\n/* more */\n");
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_EQ(formatLocation(errors[0].at), "/lib.glsl:1:1");
  EXPECT_EQ(errors[0].severity, Severity::Error);
  EXPECT_EQ(errors[0].repair, (LineEdit{"/lib.glsl", 3, "*/"}));
}

TEST(OpenComments, one_that_is_not_to_blame_is_no_error) {
  EXPECT_THAT(swallowed("/* old\nfloat a() { return 1.0; }\n/* more */\nfloat other;\n"), IsEmpty());
  EXPECT_THAT(swallowed("/* old\nfloat a() { return 1.0; }\n/* more */\nfloat shade() { return 1.0; }\n"),
              IsEmpty());
}

}  // namespace
}  // namespace orris
