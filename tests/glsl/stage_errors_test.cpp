#include <orris/glsl/compile/stage_errors.h>

#include <gmock/gmock.h>

namespace orris {
namespace {

using ::testing::ElementsAre;

std::vector<std::string> mistakes(const std::vector<std::pair<int, std::string>>& errors,
                                  const std::string& text) {
  std::vector<LogEntry> entries;
  for (const auto& [line, message] : errors) entries.push_back({.line = line, .message = message});
  std::vector<std::string> left;
  for (const LogEntry& entry : ownMistakes(entries, text))
    left.push_back(std::to_string(entry.line) + " " + entry.message);
  return left;
}

TEST(StageErrors, a_line_has_one) {
  EXPECT_THAT(mistakes({{1, "'=' : a"}, {1, "'+' : b"}, {2, "'=' : a"}}, "x;\ny;\n"),
              ElementsAre("1 '=' : a", "2 '=' : a"));
}

TEST(StageErrors, what_uses_an_undeclared_name_follows_from_it) {
  EXPECT_THAT(mistakes({{1, "'tint' : undeclared identifier"},
                        {2, "'texture' : no matching overloaded function found"},
                        {3, "'=' : cannot convert"},
                        {4, "'more' : undeclared identifier"}},
                       "tint;\ntexture(tint);\nfloat tints = 1;\ntint + more;"),
              ElementsAre("1 'tint' : undeclared identifier", "3 '=' : cannot convert",
                          "4 'more' : undeclared identifier"));
}

TEST(StageErrors, a_statement_of_many_lines_has_one) {
  const std::string call = "vec4 fog = shade(\n  uv,\n\n  depth\n);\nfloat a = fog;\n";
  EXPECT_THAT(mistakes({{5, "'shade' : no matching overloaded function found"},
                        {1, "'=' : cannot convert from 'float' to 'vec4'"},
                        {6, "'=' : cannot convert from 'vec4' to 'float'"}},
                       call),
              ElementsAre("5 'shade' : no matching overloaded function found",
                          "6 '=' : cannot convert from 'vec4' to 'float'"));
  EXPECT_THAT(mistakes({{2, "'uv' : undeclared identifier"},
                        {4, "'depth' : undeclared identifier"},
                        {5, "'shade' : no matching overloaded function found"},
                        {11, "'shade' : no matching overloaded function found"}},
                       call + "if (a > 0.5) {\n  fog = shade(\n    uv,\n    a\n  );\n}\n"),
              ElementsAre("2 'uv' : undeclared identifier", "4 'depth' : undeclared identifier"));
}

TEST(StageErrors, malformed_tokens_are_mistakes_each) {
  EXPECT_THAT(mistakes({{1, "'' : octal literal digit too large"},
                        {2, "'' : octal literal digit too large"},
                        {2, "'=' : cannot convert"}},
                       "int days[] = int[](08,\n  09);\n"),
              ElementsAre("1 '' : octal literal digit too large", "2 '' : octal literal digit too large"));
}

TEST(StageErrors, a_directive_ends_a_statement) {
  EXPECT_THAT(mistakes({{1, "'=' : a"}, {3, "'=' : b"}}, "int x = 1\n#line 7\nint y = 2\n"),
              ElementsAre("1 '=' : a", "3 '=' : b"));
}

TEST(StageErrors, warnings_and_what_has_no_line_stay) {
  const LogEntry warning{.severity = Severity::Warning, .line = 1, .message = "w"};
  EXPECT_EQ(ownMistakes({warning, warning, {.message = "all"}, {.message = "all"}}, "").size(), 4u);
}

TEST(StageErrors, are_bounded) {
  std::vector<LogEntry> entries;
  for (int line = 1; line <= 1000; ++line) entries.push_back({.line = line, .message = "'=' : a"});
  EXPECT_EQ(ownMistakes(entries, "").size(), 100u);
}

}  // namespace
}  // namespace orris
