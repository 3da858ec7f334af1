#include <orris/core/message_limits.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <orris/core/limits.h>

namespace orris {
namespace {

Diagnostic unboundedError() {
  Diagnostic d;
  d.id = "many";
  d.at = {"/lib/sky.glsl", 41, 10};
  d.message = "undeclared name 'foo'";
  return d;
}

TEST(message_limits, of_a_long_line_the_part_before_the_column_is_quoted) {
  Diagnostic d = unboundedError();
  const std::string line = std::string(100'000, 'a') + "XY" + std::string(100'000, 'b');
  d.at.column = 100'002;
  d.sourceLine = quotedLine(line, d.at.column);
  EXPECT_LE(d.sourceLine.size(), limits::kQuotedLineBytes);
  EXPECT_TRUE(d.sourceLine.ends_with("aaX"));
  const std::string text = formatDiagnostic(d);
  const std::size_t caretLine = text.rfind('\n') + 1;
  EXPECT_EQ(text.size() - caretLine - 1, 2 + d.sourceLine.size()) << "after the last character";
  EXPECT_EQ(quotedLine(line, 5).substr(0, 10), "aaaaaaaaaa");
  EXPECT_EQ(quotedLine("short", 3), "short");
  EXPECT_LE(quotedLine(line, 10'000'000).size(), limits::kQuotedLineBytes);
}

TEST(message_limits, a_cut_stands_between_characters) {
  Diagnostic d = unboundedError();
  for (int i = 0; i < 50'000; ++i) d.message += "\xC3\xBC";
  d.sourceLine = "x" + d.message;
  d.at.column = 40'000;
  Diagnostics all{d};
  boundMessages(all);
  EXPECT_LT(all[0].message.size(), limits::kMessageBytes + 10);
  EXPECT_TRUE(all[0].message.ends_with("\xC3\xBC ..."));
  EXPECT_TRUE(all[0].sourceLine.starts_with("...\xC3\xBC"));
}

TEST(message_limits, of_a_kind_the_first_are_kept_and_one_message_stands_for_the_rest) {
  Diagnostics all(2 * limits::kMessagesOfAKind, unboundedError());
  Diagnostic other = unboundedError();
  other.id = "other";
  all.push_back(other);
  boundMessages(all);
  ASSERT_EQ(all.size(), limits::kMessagesOfAKind + 2);
  EXPECT_EQ(all[limits::kMessagesOfAKind].id, "messages-left-out");
  EXPECT_THAT(all[limits::kMessagesOfAKind].message, ::testing::HasSubstr("the kind many"));
  EXPECT_EQ(all.back().id, "other");
}

TEST(message_limits, the_first_error_survives_a_full_list) {
  Diagnostic note = unboundedError();
  note.severity = Severity::Note;
  Diagnostics all(limits::kMessagesOfAKind + 5, note);
  all.push_back(unboundedError());
  boundMessages(all);
  EXPECT_TRUE(hasErrors(all));
}

TEST(message_limits, the_bytes_of_a_list_and_its_chains_are_bounded) {
  Diagnostic d = unboundedError();
  d.message = d.hint = std::string(2 * limits::kMessageBytes, 'm');
  d.includedFrom.resize(100, {"/a.glsl", 1, 0});
  d.includedFrom.back().file = "/composite.fsh";
  Diagnostics all(5'000, d);
  boundMessages(all);
  EXPECT_LT(all.size(), 4'000u);
  EXPECT_EQ(all[0].includedFrom.size(), limits::kMessageIncludes);
  EXPECT_EQ(all[0].includedFrom.back().file, "/composite.fsh");
}

}  // namespace
}  // namespace orris
