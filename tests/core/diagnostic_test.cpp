#include <orris/core/diagnostic.h>

#include <gtest/gtest.h>

namespace orris {
namespace {

Diagnostic skyError() {
  Diagnostic d;
  d.at = {"/lib/sky.glsl", 41, 10};
  d.message = "undeclared name 'foo'";
  return d;
}

TEST(diagnostic, location_severity_and_message_stand_on_one_line) {
  EXPECT_EQ(formatDiagnostic(skyError()), "/lib/sky.glsl:41:10: error: undeclared name 'foo'");
}

TEST(diagnostic, unknown_column_line_and_file_are_left_out) {
  Diagnostic d = skyError();
  d.severity = Severity::Warning;
  d.at.column = 0;
  EXPECT_EQ(formatDiagnostic(d), "/lib/sky.glsl:41: warning: undeclared name 'foo'");
  d.at.line = 0;
  EXPECT_EQ(formatDiagnostic(d), "/lib/sky.glsl: warning: undeclared name 'foo'");
  d.at.file.clear();
  d.severity = Severity::Note;
  EXPECT_EQ(formatDiagnostic(d), "note: undeclared name 'foo'");
}

TEST(diagnostic, chain_source_caret_notes_and_hint_follow_in_this_order) {
  Diagnostic d = skyError();
  d.includedFrom = {{"/lib/all.glsl", 3, 0}, {"/composite.fsh", 7, 0}};
  d.sourceLine = "\tvec3 a = foo;";
  d.at.column = 11;
  d.notes = {"expanded from macro 'SKY'"};
  d.hint = "declare it";
  EXPECT_EQ(formatDiagnostic(d),
            "/lib/sky.glsl:41:11: error: undeclared name 'foo'\n"
            "  included from /lib/all.glsl:3\n"
            "  included from /composite.fsh:7\n"
            "  \tvec3 a = foo;\n"
            "  \t         ^\n"
            "  note: expanded from macro 'SKY'\n"
            "  hint: declare it");
}

TEST(diagnostic, caret_counts_characters_not_bytes) {
  Diagnostic d = skyError();
  d.sourceLine = "/* \xC3\xBC */ foo";
  d.at.column = 10;
  EXPECT_EQ(formatDiagnostic(d),
            "/lib/sky.glsl:41:10: error: undeclared name 'foo'\n"
            "  /* \xC3\xBC */ foo\n"
            "          ^");
}

TEST(diagnostic, caret_past_the_end_stands_after_the_last_character) {
  Diagnostic d = skyError();
  d.sourceLine = "ab";
  EXPECT_EQ(formatDiagnostic(d), "/lib/sky.glsl:41:10: error: undeclared name 'foo'\n  ab\n    ^");
}

TEST(diagnostic, has_errors_ignores_warnings_and_notes) {
  Diagnostics all(2, skyError());
  all[0].severity = Severity::Note;
  all[1].severity = Severity::Warning;
  EXPECT_FALSE(hasErrors(all));
  all.push_back(skyError());
  EXPECT_TRUE(hasErrors(all));
}

TEST(diagnostic, repetitions_go_but_differences_stay) {
  Diagnostics all(3, skyError());
  all[1].notes = {"the same problem in other words"};
  all[2].at.column = 11;
  all.push_back(skyError());
  all.back().severity = Severity::Warning;
  removeDuplicates(all);
  ASSERT_EQ(all.size(), 3u);
  EXPECT_TRUE(all[0].notes.empty());
  EXPECT_EQ(all[1].at.column, 11);
  EXPECT_EQ(all[2].severity, Severity::Warning);
}

}  // namespace
}  // namespace orris
