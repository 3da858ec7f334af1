#include "glsl/conditional_balance.h"

#include <gtest/gtest.h>

#include "glsl_test.h"

namespace orris::test {
namespace {

/// "/a.glsl:3 unclosed ifdef", a line for each file.
std::string unbalanced(const Files& files) {
  FlatSource source;
  flattenInto(source, files, "/a.glsl", -1, 0);
  std::string text;
  for (const UnbalancedConditional& found : findUnbalancedConditionals(source)) {
    constexpr const char* kKinds[] = {"unclosed", "stray", "misspelt"};
    text += source.sites[std::size_t(found.at.site)].file + ":" + std::to_string(found.at.line) +
            " " + kKinds[int(found.kind)] + " " + found.directive +
            (found.meant.empty() ? "" : " for " + found.meant) + "\n";
  }
  return text;
}

TEST(conditionalBalance, files_that_pair_are_quiet) {
  EXPECT_EQ(
      unbalanced({{"/a.glsl", "#ifdef A\n  #if B\n  #endif\n#else\n/*\n#if C\n*/\n#endif\n"}}), "");
}

TEST(conditionalBalance, an_endif_is_missing_where_the_indentation_breaks) {
  EXPECT_EQ(
      unbalanced({{"/a.glsl",
                   "#ifdef A\n  #ifdef B\n  x\n#endif\n#ifdef C\n  #if D\n  #endif\n#endif\n"}}),
      "/a.glsl:2 unclosed ifdef\n");
}

TEST(conditionalBalance, an_else_belongs_to_the_if_above_it) {
  EXPECT_EQ(unbalanced({{"/a.glsl",
                         "#ifdef A\n  #if B\n  x\n  #endif\n  #else\n  y\n  #endif\n#endif\n"}}),
            "/a.glsl:4 stray endif\n");
}

TEST(conditionalBalance, braces_tell_where_nothing_is_indented) {
  EXPECT_EQ(unbalanced({{"/a.glsl",
                         "#ifdef FRAGMENT\nvoid main() {\n#ifdef B\nx;\n}\n#endif\n"
                         "#ifdef VERTEX\nvoid main() {\n}\n#endif\n"}}),
            "/a.glsl:3 unclosed ifdef\n");
}

TEST(conditionalBalance, an_include_guard_closes_at_the_end) {
  EXPECT_EQ(
      unbalanced({{"/a.glsl",
                   "// a\n#if !defined A\n#define A\n#ifdef B\nx\n#ifdef C\n#endif\n#endif\n"}}),
      "/a.glsl:4 unclosed ifdef\n");
}

TEST(conditionalBalance, each_file_is_judged_alone) {
  EXPECT_EQ(unbalanced({{"/a.glsl", "#ifdef A\n#include \"/b.glsl\"\n#endif\nx\n#endif\n"},
                        {"/b.glsl", "#ifdef B\n"}}),
            "/a.glsl:5 stray endif\n/b.glsl:1 unclosed ifdef\n");
}

TEST(conditionalBalance, a_misspelt_endif_is_the_cause_also_where_nothing_is_read) {
  EXPECT_EQ(unbalanced({{"/a.glsl", "#ifdef A\n#endfi\n#ifdef B\n#endif\n"}}),
            "/a.glsl:2 misspelt endfi for endif\n");
}

}  // namespace
}  // namespace orris::test
