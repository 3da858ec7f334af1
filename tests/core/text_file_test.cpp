#include <orris/core/files/text_file.h>

#include <gtest/gtest.h>

#include <orris/core/limits.h>

namespace orris {
namespace {

TextFile read(const std::string& path, const std::string& bytes) {
  return readTextFile(*memorySource({{path, bytes}}), path);
}

std::string problemOf(const std::string& path, const std::string& bytes) {
  const TextFile file = read(path, bytes);
  EXPECT_FALSE(file.ok);
  EXPECT_TRUE(file.bytes.empty());
  const std::string text = formatDiagnostic(file.problem);
  return text.substr(0, text.find('\n'));
}

TEST(text_file, what_packs_have_is_read_as_it_is) {
  EXPECT_EQ(read("/a.fsh", "\xEF\xBB\xBF#version 120\r\n").bytes, "\xEF\xBB\xBF#version 120\r\n");
  EXPECT_TRUE(read("/a.fsh", "").ok);
  EXPECT_TRUE(read("/a.fsh", std::string(limits::kTextFileBytes, 'a')).ok);
  EXPECT_TRUE(read("/a.fsh", std::string(limits::kTextFileLines - 1, '\n')).ok);
}

TEST(text_file, an_absent_file_is_no_problem_of_its_own) {
  const TextFile file = readTextFile(*memorySource({}), "/a.fsh");
  EXPECT_FALSE(file.ok);
  EXPECT_EQ(file.problem.id, "");
}

TEST(text_file, bytes_and_lines_are_limited) {
  EXPECT_EQ(problemOf("/a.fsh", "\n" + std::string(limits::kTextFileBytes, 'a')),
            "/a.fsh:2: error: the file has 4194305 bytes, more than 4194304; it is not read");
  for (const std::string end : {"\n", "\r", "\r\n"}) {
    std::string lines;
    for (std::size_t i = 0; i <= limits::kTextFileLines; ++i) lines += end;
    EXPECT_EQ(problemOf("/a.fsh", lines),
              "/a.fsh:100001: error: the file has more than 100000 lines; it is not read");
  }
}

TEST(text_file, properties_are_limited_in_lines_and_words) {
  std::string lines, words;
  for (std::size_t i = 0; i <= limits::kPropertyLines; ++i) lines += "a=1\n\n";
  for (std::size_t i = 0; i <= limits::kPropertyWords; ++i) words += "a ";
  EXPECT_TRUE(read("/a.fsh", lines + words).ok);
  EXPECT_EQ(
      problemOf("/block.properties", lines),
      "/block.properties:40001: error: the file has more than 20000 lines that are not blank; "
      "it is not read");
  EXPECT_EQ(problemOf("/lang/en_us.lang", "\n" + words),
            "/lang/en_us.lang:2: error: the file has more than 200000 words; it is not read");
}

TEST(text_file, utf16_is_named) {
  std::string little, big;
  for (const char c : std::string("#version 330 compatibility")) {
    little += std::string{c, '\0'};
    big += std::string{'\0', c};
  }
  for (const std::string& bytes : {little, big, "\xFF\xFE" + little, "\xFE\xFF" + big})
    EXPECT_EQ(problemOf("/a.fsh", bytes),
              "/a.fsh:1:1: error: this file is UTF-16, which no host reads");
  EXPECT_TRUE(read("/a.fsh", std::string(100, '\0')).ok);
}

TEST(text_file, a_refused_file_is_reported_where_asked_for) {
  Diagnostics diagnostics;
  EXPECT_FALSE(readText(*memorySource({{"/a.fsh", "\xFF\xFE"}}), "/a.fsh", diagnostics));
  EXPECT_FALSE(readText(*memorySource({}), "/a.fsh", diagnostics));
  ASSERT_EQ(diagnostics.size(), 1u);
  EXPECT_EQ(diagnostics[0].hint, "save it as UTF-8");
}

}  // namespace
}  // namespace orris
