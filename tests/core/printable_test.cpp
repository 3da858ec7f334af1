#include <orris/core/printable.h>

#include <gtest/gtest.h>

#include <orris/core/diagnostic.h>

namespace orris {
namespace {

TEST(printable, text_of_all_scripts_and_tabs_stay) {
  const std::string text = "\tf\xC3\xBCr \xE6\xB0\xB4 \xF0\x9F\x8C\x8A a::b #define A(x) #x ## y a[0]";
  EXPECT_EQ(printable(text), text);
}

TEST(printable, control_characters_are_shown_not_obeyed) {
  EXPECT_EQ(printable("a\x1b[2Jb\r\nc\x7f"), "a\\x1b[2Jb\\r\\nc\\x7f");
  EXPECT_EQ(printable(std::string_view("\0", 1)), "\\x00");
}

TEST(printable, escapes_of_eight_bits_are_shown_too) {
  EXPECT_EQ(printable("\xC2\x9B" "2J"), "\\x9b2J");
  EXPECT_EQ(printable("\x9B" "2J"), "\xEF\xBF\xBD" "2J");
}

TEST(printable, marks_that_turn_the_direction_of_writing_are_shown) {
  EXPECT_EQ(printable("a\xE2\x80\xAE" "b\xE2\x81\xA6"), "a\\u202eb\\u2066");
}

TEST(printable, no_line_begins_as_a_command_of_github) {
  EXPECT_EQ(printable("::stop-commands::x"), "\\x3a:stop-commands::x");
  EXPECT_EQ(printable(" \t::error::x"), " \t\\x3a:error::x");
  EXPECT_EQ(printableLines("a\n::error::x\n  ::b::\n"), "a\n\\x3a:error::x\n  \\x3a:b::\n");
}

TEST(printable, no_command_in_brackets_is_left_anywhere) {
  EXPECT_EQ(printable("x ##[error]y"), "x #\\x23[error]y");
  EXPECT_EQ(printable("##vso[task.setvariable variable=a]b"),
            "#\\x23vso[task.setvariable variable=a]b");
  EXPECT_EQ(printable("a###teamcity[x]"), "a##\\x23teamcity[x]");
}

TEST(printable, a_message_is_one_line_for_each_of_its_texts) {
  Diagnostic d;
  d.at = {"/a\n::error::b", 1, 3};
  d.message = "no \"\x1b[31m\"";
  d.sourceLine = "::stop-commands::x";
  d.notes = {"a\n##[error]b"};
  d.hint = "c\r::d::";
  EXPECT_EQ(formatDiagnostic(d),
            "/a\\n::error::b:1:3: error: no \"\\x1b[31m\"\n"
            "  \\x3a:stop-commands::x\n"
            "       ^\n"
            "  note: a\\n#\\x23[error]b\n"
            "  hint: c\\r::d::");
}

}  // namespace
}  // namespace orris
