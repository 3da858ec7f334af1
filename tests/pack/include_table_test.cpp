// Which lines include what. Contract: options.csv inc.*. Iris: FileNode, AbsolutePackPath,
// IncludeGraph.
#include <gmock/gmock.h>

#include <orris/core/files/file_source.h>
#include <orris/pack/files/include_graph.h>

namespace orris {
namespace {

struct IncludeLineCase {
  const char* line;
  const char* outcome;  ///< the file, or the id of the error
};

std::string outcome(const std::string& line) {
  const auto source = memorySource({{"/world0/composite.fsh", line},
                                    {"/lib/a.glsl", ""},
                                    {"/world0/b.glsl", ""},
                                    {"/world0/Case.glsl", ""},
                                    {"/with space.glsl", ""}});
  Diagnostics diagnostics;
  const IncludeGraph graph = readIncludeGraph(*source, {"/world0/composite.fsh"}, diagnostics);
  std::string result;
  for (const auto& [file, lines] : graph.includes) {
    for (const auto& [number, target] : lines) result += target;
  }
  for (const Diagnostic& diagnostic : diagnostics) {
    result += (result.empty() ? "" : " ") + diagnostic.id;
  }
  return result;
}

TEST(IncludeTable, lines) {
  const IncludeLineCase kCases[] = {
      {"#include \"/lib/a.glsl\"", "/lib/a.glsl"},
      {"  \t#include \"/lib/a.glsl\"  ", "/lib/a.glsl"},
      {"#include\t\"/lib/a.glsl\"", "/lib/a.glsl"},
      {"#include   \"/lib/a.glsl\"", "/lib/a.glsl"},
      {"#include \"/lib//./a.glsl\"", "/lib/a.glsl"},
      {"#include \"b.glsl\"", "/world0/b.glsl"},
      {"#include \"./b.glsl\"", "/world0/b.glsl"},
      {"#include \"../lib/a.glsl\"", "/lib/a.glsl"},
      {"#include \"/world0/../lib/a.glsl\"", "/lib/a.glsl"},
      {"#include \"/with space.glsl\"", "/with space.glsl"},
      {"#include /lib/a.glsl", "/lib/a.glsl"},                          // quotes are not enforced
      {"#include \"/lib/a.glsl", "/lib/a.glsl"},                        // nor are both
      {"#include \"../../lib/a.glsl\"", "/lib/a.glsl include-escape"},  // Iris stays at the root
      {"#include \"../../../etc/passwd\"", "include-escape"},
      {"#include \"lib\\a.glsl\"", "include-escape"},
      {"#include \"/lib/A.glsl\"", "/lib/a.glsl include-capitals"},  // a zip tells cases apart
      {"#include \"case.glsl\"", "/world0/Case.glsl include-capitals"},
      {"#include \"lib/a.glsl\"", "include-missing"},
      {"#include </lib/a.glsl>", "include-missing"},
      {"#include \"/lib/a.glsl\" // why", "/lib/a.glsl include-syntax"},
      {"#include \"/lib/none.glsl\" // why", "include-syntax"},
      {"#include \"/../shaders/lib/a.glsl\"", "/lib/a.glsl include-escape"},
      {"#include \"/lib/a.glsl\" \"b.glsl\"", "include-syntax"},
      {"#include", "include-syntax"},
      {"// #include \"/none.glsl\"", ""},
      {"# include \"/none.glsl\"", ""},
      {"int x; #include \"/none.glsl\"", ""},
      {"#define FILE \"/lib/a.glsl\"", ""},
  };
  for (const IncludeLineCase& test : kCases) EXPECT_EQ(outcome(test.line), test.outcome) << test.line;
}

TEST(IncludeTable, a_path_with_other_capitals_is_proposed_with_the_reason) {
  const auto hintOf = [](const std::string& line) {
    const auto source = memorySource({{"/final.fsh", line}, {"/lib/light.glsl", ""}});
    Diagnostics diagnostics;
    readIncludeGraph(*source, {"/final.fsh"}, diagnostics);
    return diagnostics.empty() ? "" : diagnostics.front().hint;
  };
  EXPECT_EQ(hintOf("#include \"/lib/Light.glsl\""),
            "did you mean /lib/light.glsl? Capitals count in a zip and on Linux");
  EXPECT_EQ(hintOf("#include \"/lib/lihgt.glsl\""), "did you mean /lib/light.glsl?");
}

TEST(IncludeTable, conditions_and_comments_hide_nothing) {
  for (const char* text :
       {"#if 0\n#include \"/none.glsl\"\n#endif", "/*\n#include \"/none.glsl\"\n*/",
        "#ifndef GUARD\n#include \"/none.glsl\"\n#endif"}) {
    EXPECT_EQ(outcome(text), "include-missing") << text;
  }
}

TEST(IncludeTable, guards_do_not_break_a_circle_and_repetition_is_none) {
  const auto messages = [](std::map<std::string, std::string> files) {
    Diagnostics diagnostics;
    readIncludeGraph(*memorySource(std::move(files)), {"/final.fsh"}, diagnostics);
    std::vector<std::string> ids;
    for (const Diagnostic& d : diagnostics) ids.push_back(d.id);
    return ids;
  };
  EXPECT_THAT(messages({{"/final.fsh", "#include \"a\""},
                        {"/a", "#ifndef A\n#define A\n#include \"b\"\n#endif"},
                        {"/b", "#include \"a\""}}),
              testing::ElementsAre("include-cycle"));
  EXPECT_THAT(messages({{"/final.fsh", "#include \"final.fsh\""}}),
              testing::ElementsAre("include-cycle"));
  EXPECT_THAT(messages({{"/final.fsh", "#include \"a\"\n#include \"b\"\n#include \"a\""},
                        {"/a", "#include \"b\""},
                        {"/b", ""}}),
              testing::IsEmpty());
}

}  // namespace
}  // namespace orris
