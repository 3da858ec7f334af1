#include <orris/pack/files/properties_text.h>

#include <gtest/gtest.h>

namespace orris {
namespace {

using Pairs = std::vector<std::pair<std::string, std::string>>;

Pairs pairs(const std::vector<PropertyEntry>& entries) {
  Pairs result;
  for (const PropertyEntry& entry : entries) result.emplace_back(entry.key, entry.value);
  return result;
}

TEST(PropertiesText, separators_and_comments) {
  EXPECT_EQ(pairs(parseProperties(
                "f", "# c\n! c\na=1\nb : 2\nc 3\n  d\n\ne = = 4\r\nf=", Continuation::Java)),
            (Pairs{{"a", "1"}, {"b", "2"}, {"c", "3"}, {"d", ""}, {"e", "= 4"}, {"f", ""}}));
}

TEST(PropertiesText, escapes) {
  EXPECT_EQ(pairs(parseProperties("f", "a\\=b = x\\ty\\\\z\\u00e9\\q\n", Continuation::Java)),
            (Pairs{{"a=b", "x\ty\\z\xC3\xA9q"}}));
  EXPECT_EQ(pairs(parseProperties("f", "a = \\u12\nb = \\", Continuation::Java)),
            (Pairs{{"a", "u12"}, {"b", ""}}));
}

TEST(PropertiesText, java_continues_with_the_very_next_line) {
  EXPECT_EQ(
      pairs(parseProperties("f", "a = 1 \\\n  2\nb = 1 \\\n\nc = 1 \\\\\nd=2", Continuation::Java)),
      (Pairs{{"a", "1 2"}, {"b", "1 "}, {"c", "1 \\"}, {"d", "2"}}));
}

TEST(PropertiesText, preprocessed_skips_blank_lines_but_ends_at_a_directive) {
  EXPECT_EQ(pairs(parseProperties("f", "a = 1 \\\n\n2\n", Continuation::Preprocessed)),
            (Pairs{{"a", "1 2"}}));
  EXPECT_EQ(pairs(parseProperties("f", "a = 1 \\\n\nb = 2\n", Continuation::Preprocessed,
                                  "a = 1 \\\n#endif\nb = 2\n")),
            (Pairs{{"a", "1 "}, {"b", "2"}}));
}

TEST(PropertiesText, last_value_stands_where_the_key_came_first) {
  EXPECT_EQ(pairs(lastValues(parseProperties("f", "a=1\nb=2\na=3\n", Continuation::Java))),
            (Pairs{{"a", "3"}, {"b", "2"}}));
}

TEST(PropertiesText, diagnostics_point_at_the_word) {
  const auto entries = parseProperties("/f", "\n  screen = AB \\\n    A B\n", Continuation::Java);
  EXPECT_EQ(
      formatDiagnostic(propertyDiagnostic(Severity::Warning, "x", entries[0], "no A", "", "A")),
      "/f:3:5: warning: no A\n      A B\n      ^");
  EXPECT_EQ(propertyDiagnostic(Severity::Warning, "x", entries[0], "no C", "", "C").at,
            (SourceLocation{"/f", 2, 3}));
}

}  // namespace
}  // namespace orris
