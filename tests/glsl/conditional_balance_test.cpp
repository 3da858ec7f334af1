#include <orris/glsl/syntax/conditional_balance.h>

#include <gtest/gtest.h>

#include <orris/glsl/syntax/branch_room.h>
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

TEST(conditionalBalance, an_endif_in_a_comment_closes_nothing) {
  EXPECT_EQ(unbalanced({{"/a.glsl", "#ifdef A\nx\n/*\n#endif\n*/\n"}}), "/a.glsl:1 unclosed ifdef\n");
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

TEST(conditionalBalance, a_branch_is_text_at_one_depth_of_braces) {
  const auto room = [](std::initializer_list<const char*> lines) {
    BranchText text;
    text.addLine("void f() {", false, 1);
    text.addConditional(2);
    int number = 3;
    for (const std::string_view line : lines) text.addLine(line, line.empty(), number++);
    return text.room();
  };
  EXPECT_EQ(room({"x;", "}"}).begins, 0);
  EXPECT_EQ(room({"x;", "}", "y;"}).begins, 3);
  EXPECT_EQ(room({"x;", "}", "", "y;"}).begins, 6);
  EXPECT_EQ(room({"x;", "}"}).ends, 3);
  EXPECT_EQ(room({"x;", "y;", "", "z;"}).ends, 4);
  EXPECT_EQ(room({"if (a) {", "y;"}).ends, 0);
  EXPECT_EQ(room({"}"}).ends, 0);
}

TEST(conditionalBalance, a_block_of_text_without_blank_lines_is_closed_so) {
  const std::string head = "#ifndef A\n#define A\n\nx;\n\n#ifdef B\ny;\n";
  EXPECT_EQ(unbalanced({{"/a.glsl", head + "#endif\n"}}), "/a.glsl:1 unclosed ifndef\n");
  EXPECT_EQ(unbalanced({{"/a.glsl", head + "\n#endif\n"}}), "/a.glsl:6 unclosed ifdef\n");
}

TEST(conditionalBalance, an_included_file_is_text) {
  std::string text;
  for (int i = 0; i < 20; ++i) text += "x;\n";
  EXPECT_EQ(unbalanced({{"/a.glsl", "#ifdef A\n" + text +
                                        "#ifdef B\n#include \"/b.glsl\"\n\n#ifdef C\nz;\n#endif\n" +
                                        text + "#endif\n"},
                        {"/b.glsl", "b;\n"}}),
            "/a.glsl:22 unclosed ifdef\n");
}

TEST(conditionalBalance, a_branch_does_not_go_on_behind_the_end_of_its_block) {
  EXPECT_EQ(
      unbalanced({{"/a.glsl",
                   "void f() {\n#if 1\na;\n#else\nb;\n#endif\n}\nvoid g() {\nc;\n#elif 1\nd;\n"
                   "#elif 1\ne;\n#endif\n}\n"}}),
      "/a.glsl:14 stray endif\n");
}

TEST(conditionalBalance, short_blocks_in_long_ones_are_likelier_than_two_of_middle_length) {
  std::string text;
  for (int i = 0; i < 20; ++i) text += "x;\n";
  EXPECT_EQ(unbalanced({{"/a.glsl", "#ifdef A\n" + text + "#ifdef B\ny;\n#ifdef C\nz;\n#endif\n" +
                                        text + "#endif\n"}}),
            "/a.glsl:22 unclosed ifdef\n");
}

TEST(conditionalBalance, each_main_stands_in_a_conditional_of_its_stage) {
  EXPECT_EQ(unbalanced({{"/a.glsl",
                         "#ifdef VSH\nvoid main() {}\n#else\n#if A\nx;\n#else\ny;\n#endif\n"
                         "void main() {}\n"}}),
            "/a.glsl:1 unclosed ifdef\n");
  EXPECT_EQ(
      unbalanced(
          {{"/a.glsl", "#ifdef VSH\nvoid main() {}\nx;\n#endif\n\ny;\nvoid main() {}\n#endif\n"}}),
      "/a.glsl:8 stray endif\n");
}

TEST(conditionalBalance, a_branch_with_a_main_does_not_end_before_it) {
  EXPECT_EQ(unbalanced({{"/a.glsl",
                         "#ifdef VSH\na;\na;\na;\na;\n\nvoid main() {\n  b;\n}\n\n#ifdef "
                         "FSH\nc;\n\nd;\n\nvoid main() "
                         "{\n#ifdef A\ne;\n#endif\n}\n\n#endif\n"}}),
            "/a.glsl:1 unclosed ifdef\n");
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
