#include <orris/pack/ids/id_lines.h>

#include <gmock/gmock.h>

namespace orris {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

struct Read {
  std::vector<std::pair<std::string, std::string>> pairs;
  std::vector<std::string> problems;
  std::vector<PropertyEntry> entries;
};

/// `original` holds directives and comments where `text` has blank lines.
Read read(const std::string& text, const std::string& original) {
  Read result;
  Diagnostics diagnostics;
  result.entries = parseIdLines("/f", text, original, &diagnostics);
  for (const PropertyEntry& entry : result.entries)
    result.pairs.emplace_back(entry.key, entry.value);
  for (const Diagnostic& d : diagnostics)
    result.problems.push_back(d.id + " " + std::to_string(d.at.line) + ":" +
                              std::to_string(d.at.column));
  return result;
}

TEST(IdLines, a_list_goes_on_after_a_directive) {
  const Read found = read("block.1 = a \\\n\nb\n", "block.1 = a \\\n#endif\nb\n");
  EXPECT_THAT(found.pairs, ElementsAre(Pair("block.1", "a  b")));
  EXPECT_THAT(found.problems, IsEmpty());
}

TEST(IdLines, a_key_directly_after_a_backslash_is_part_of_the_list) {
  const Read found = read("block.1 = a \\\n  block.2 = b c\nblock.3 = d\n",
                          "block.1 = a \\\n  block.2 = b c\nblock.3 = d\n");
  EXPECT_THAT(found.pairs, ElementsAre(Pair("block.1", "a block.2 = b c"), Pair("block.3", "d")));
  EXPECT_THAT(found.problems, ElementsAre("id-swallowed 2:3"));
}

TEST(IdLines, a_comment_after_a_backslash_costs_the_last_letter) {
  const Read found = read("block.1 = wheat potatoes \\\n\nblock.2 = b\n",
                          "block.1 = wheat potatoes \\\n# 2: more\nblock.2 = b\n");
  EXPECT_THAT(found.pairs, ElementsAre(Pair("block.1", "wheat potatoe"), Pair("block.2", "b")));
  EXPECT_THAT(found.problems, ElementsAre("id-letter-lost 1:24"));
  EXPECT_EQ(found.entries[1].at, (SourceLocation{"/f", 3, 1}));
  EXPECT_THAT(found.entries[1].lines, ElementsAre("block.2 = b"));
}

TEST(IdLines, a_render_layer_after_a_backslash_is_lost_with_and_without_a_comment) {
  for (const char* between : {"", "\n"}) {
    const std::string text =
        std::string("block.1 = a \\\n") + between + "layer.solid = b\nblock.2 = c\n";
    std::string original = text;
    if (*between) original.insert(original.find("\n\n") + 1, "# note");
    const Read found = read(text, original);
    ASSERT_EQ(found.pairs.size(), 2u);
    EXPECT_EQ(found.pairs[0].first, "block.1");
    EXPECT_THAT(found.pairs[0].second, testing::HasSubstr("layer.solid = b"));
    EXPECT_THAT(found.problems, ElementsAre(testing::StartsWith("id-swallowed")));
  }
}

TEST(IdLines, two_keys_on_one_line_are_split) {
  const Read found = read("block.1 = aa block.2 = bb\n", "block.1 = aa block.2 = bb\n");
  EXPECT_THAT(found.pairs, ElementsAre(Pair("block.1", "a"), Pair("block.2", "bb")));
  EXPECT_THAT(found.problems, ElementsAre("id-letter-lost 1:12"));
  EXPECT_EQ(found.entries[1].at.column, 14);
}

TEST(IdLines, an_empty_list_loses_nothing) {
  const Read found = read("block.1 = \\\n\nblock.2 = b\n", "block.1 = \\\n# water\nblock.2 = b\n");
  EXPECT_THAT(found.pairs, ElementsAre(Pair("block.1", ""), Pair("block.2", "b")));
  EXPECT_THAT(found.problems, IsEmpty());
}

TEST(IdLines, what_ends_in_a_backslash_may_be_the_last_line) {
  EXPECT_THAT(read("block.1 = a \\", "block.1 = a \\").pairs, ElementsAre(Pair("block.1", "a ")));
  EXPECT_THAT(read("block.1 = a \\\n\n", "block.1 = a \\\n#endif\n").pairs,
              ElementsAre(Pair("block.1", "a  ")));
  EXPECT_THAT(read("", "").pairs, IsEmpty());
}

}  // namespace
}  // namespace orris
