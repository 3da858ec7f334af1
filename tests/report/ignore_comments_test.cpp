#include <orris/report/ignore_comments.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <climits>

namespace orris {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// "id first-last" of each mark.
std::vector<std::string> marksOf(const std::string& file, const std::string& text) {
  std::vector<std::string> result;
  for (const IgnoreMark& mark : readIgnoreMarks(file, text)) {
    const std::string last = mark.last == INT_MAX ? "end" : std::to_string(mark.last);
    result.push_back(mark.id + " " + std::to_string(mark.first) + "-" + last);
  }
  return result;
}

TEST(IgnoreComments, besideCodeCoversItsLineOnly) {
  EXPECT_THAT(
      marksOf("/a.fsh", "\nfloat a; // orris: ignore(uniform-unknown) by a mod\nfloat b;\n"),
      ElementsAre("uniform-unknown 2-2"));
}

TEST(IgnoreComments, aloneCoversTheNextLine) {
  EXPECT_THAT(marksOf("/a.fsh", "  // orris: ignore(a)\nfloat a;\nfloat b;\n"),
              ElementsAre("a 2-2"));
}

TEST(IgnoreComments, severalStackAboveOneLine) {
  EXPECT_THAT(marksOf("/a.fsh", "// orris: ignore(a)\n\n/* orris: ignore( b , c ) */\nfloat a;\n"),
              ElementsAre("a 4-4", "b 4-4", "c 4-4"));
}

TEST(IgnoreComments, blockCommentBeforeCodeIsBesideIt) {
  EXPECT_THAT(marksOf("/a.fsh", "/* orris: ignore(a) */ float a;\n"), ElementsAre("a 1-1"));
}

TEST(IgnoreComments, coverAllOfAContinuedLine) {
  EXPECT_THAT(marksOf("/a.fsh", "// orris: ignore(a)\n#define A \\\n  1 + \\\n  2\nint b;\n"),
              ElementsAre("a 2-4"));
}

TEST(IgnoreComments, coverAWholeFile) {
  EXPECT_THAT(marksOf("/a.fsh", "int a;\n// orris: ignore-file(texture-missing)\n"),
              ElementsAre("texture-missing 0-end"));
}

TEST(IgnoreComments, inPropertiesCoverAllOfAContinuedValue) {
  EXPECT_THAT(marksOf("/shaders.properties",
                      "# orris: ignore(screen-option)\nscreen = A \\\n B \\\n C\nx=y\n"),
              ElementsAre("screen-option 2-4"));
}

TEST(IgnoreComments, inPropertiesAContinuedValueHoldsNone) {
  EXPECT_THAT(marksOf("/shaders.properties", "screen = A \\\n# orris: ignore(a)\nB = 1\n"),
              IsEmpty());
}

TEST(IgnoreComments, inPropertiesABackslashDoesNotContinueAComment) {
  EXPECT_THAT(marksOf("/lang/en_us.lang", "# orris: ignore(a) \\\n# orris: ignore(b)\nB = 1\n"),
              ElementsAre("a 3-3", "b 3-3"));
}

TEST(IgnoreComments, inPropertiesNoneStandsBehindAValue) {
  EXPECT_THAT(marksOf("/shaders.properties", "a=b # orris: ignore(a)\n"), IsEmpty());
}

TEST(IgnoreComments, needTheExactForm) {
  EXPECT_THAT(
      marksOf(
          "/a.fsh",
          "// see orris: ignore(a)\n# orris: ignore(a)\n// orris: ignore a\n"
          "// orris: ignore(a\n// orris: ignored(a)\n// orris: ignore-file\norris: ignore(a)\n"),
      IsEmpty());
}

std::string text(const Diagnostics& diagnostics) {
  std::string result;
  for (const Diagnostic& d : diagnostics) result += formatDiagnostic(d) + "\n";
  return result;
}

TEST(IgnoreComments, silenceIdAndLine) {
  const auto files = memorySource({{"/a.fsh", "int a; // orris: ignore(glsl-compile)\nint b;\n"}});
  IgnoreComments comments(*files);
  EXPECT_FALSE(comments.silences({.id = "glsl-compile", .at = {"/a.fsh", 2, 1}}));
  EXPECT_FALSE(comments.silences({.id = "glsl-link", .at = {"/a.fsh", 1, 1}}));
  EXPECT_FALSE(comments.silences({.id = "glsl-compile", .at = {"/b.fsh", 1, 1}}));
  EXPECT_EQ(text(comments.problems()),
            "/a.fsh:1:8: note: this comment silences no glsl-compile\n"
            "  int a; // orris: ignore(glsl-compile)\n"
            "         ^\n"
            "  hint: take it out, or put it on the line of the problem or alone above it\n");
  EXPECT_TRUE(comments.silences({.id = "glsl-compile", .at = {"/a.fsh", 1, 5}}));
  EXPECT_THAT(comments.problems(), IsEmpty());
}

TEST(IgnoreComments, ofAFileSilenceWhatHasNoLine) {
  const auto files = memorySource({{"/a.fsh", "// orris: ignore-file(glsl-link)\n"}});
  IgnoreComments comments(*files);
  EXPECT_TRUE(comments.silences({.id = "glsl-link", .at = {"/a.fsh", 0, 0}}));
}

TEST(IgnoreComments, withAnUnknownIdAreReportedWithTheNearest) {
  const auto files = memorySource({{"/lib/a.glsl", "// orris: ignore(glsl-complie)\n"}});
  EXPECT_EQ(text(IgnoreComments(*files).problems()),
            "/lib/a.glsl:1:1: warning: there is no check \"glsl-complie\"\n"
            "  // orris: ignore(glsl-complie)\n"
            "  ^\n"
            "  hint: did you mean glsl-compile?\n");
}

}  // namespace
}  // namespace orris
