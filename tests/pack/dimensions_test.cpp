#include <orris/pack/programs/dimensions.h>

#include <gmock/gmock.h>

namespace orris {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// What is said of a dimension.properties in a pack with programs in world0, world1 and moon.
std::vector<std::string> problems(const std::string& properties) {
  const auto source = memorySource({{"/dimension.properties", properties},
                                    {"/world0/final.fsh", ""},
                                    {"/world1/final.fsh", ""},
                                    {"/moon/final.fsh", ""},
                                    {"/lib/a.glsl", ""}});
  Diagnostics diagnostics;
  readDimensions(*source, {}, diagnostics);
  std::vector<std::string> messages;
  for (const Diagnostic& d : diagnostics) {
    messages.push_back(std::to_string(d.at.line) + ": " + severityName(d.severity) + ": " +
                       d.message + (d.hint.empty() ? "" : " | " + d.hint));
  }
  return messages;
}

TEST(Dimensions, folders_that_exist_are_quiet) {
  EXPECT_THAT(problems("dimension.world0 = *\ndimension.moon=a:moon b:moon\ndimension.lib = c\n"),
              IsEmpty());
  // A folder for nothing may be missing.
  EXPECT_THAT(problems("dimension.worldx =\n"), IsEmpty());
}

// Iris: ShaderPack.getProgramSet logs an error.
TEST(Dimensions, a_folder_that_is_not_there_is_a_warning) {
  EXPECT_THAT(problems("dimension.world0 = minecraft:overworld\n"
                       "dimension.wolrd1 = minecraft:the_end\ndimension.sun = a:sun\n"),
              ElementsAre("2: warning: the pack has no folder wolrd1, so minecraft:the_end has no "
                          "programs of its own | did you mean world1?",
                          "3: warning: the pack has no folder sun, so a:sun has no programs of its "
                          "own"));
}

TEST(Dimensions, other_dimensions_may_be_left_without_programs) {
  const std::string rest = "dimension.world0 = a\ndimension.world1 = b\ndimension.moon = c\n";
  EXPECT_THAT(problems(rest + "dimension.worldx = *\n"),
              ElementsAre("4: note: the pack has no folder worldx, so any other dimension has no "
                          "programs of its own"));
  EXPECT_THAT(problems("dimension.wrold0 = *\ndimension.world1 = b\n"),
              ElementsAre("1: warning: the pack has no folder wrold0, so any other dimension has "
                          "no programs of its own | did you mean world0?"));
}

/// The folders of a pack with programs in world0 and directly in shaders/.
std::vector<std::string> readFolders(const MacroDefinitions& environment, const char* other,
                                     Diagnostics& diagnostics) {
  const auto source = memorySource({{"/final.fsh", ""}, {other, ""}});
  return readDimensions(*source, environment, diagnostics).readFolders();
}

// Iris: the base of all dimensions is world0, so nothing reads the folder above it.
TEST(Dimensions, programs_above_world0_are_for_no_dimension_of_iris) {
  Diagnostics iris, optifine;
  EXPECT_THAT(readFolders({{"IS_IRIS", ""}}, "/world0/final.fsh", iris), ElementsAre("/world0"));
  ASSERT_EQ(iris.size(), 1u);
  EXPECT_EQ(formatDiagnostic(iris[0]),
            "/: note: no dimension gets the programs directly in shaders/: world0 serves all that "
            "have no folder of their own\n"
            "  hint: they are not checked; name them with --dimensions / to check them");
  EXPECT_THAT(readFolders({}, "/world0/final.fsh", optifine), ElementsAre("/", "/world0"));
  EXPECT_THAT(optifine, IsEmpty());
}

TEST(Dimensions, programs_above_the_nether_are_for_all_others) {
  Diagnostics diagnostics;
  EXPECT_THAT(readFolders({{"IS_IRIS", ""}}, "/world-1/final.fsh", diagnostics),
              ElementsAre("/", "/world-1"));
  EXPECT_THAT(diagnostics, IsEmpty());
}

}  // namespace
}  // namespace orris
