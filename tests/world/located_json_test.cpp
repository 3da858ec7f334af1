#include <orris/world/files/located_json.h>

#include <gtest/gtest.h>

namespace orris {
namespace {

void checkOffsets(const std::string& text, const JsonNode& node) {
  const std::string starts[] = {"n", "tf", "-0123456789", "-0123456789", "\"", "[", "{"};
  ASSERT_LT(node.offset, text.size());
  EXPECT_NE(starts[int(node.kind)].find(text[node.offset]), std::string::npos) << node.offset;
  for (const JsonNode& item : node.items) checkOffsets(text, item);
  for (const JsonMember& member : node.members) {
    EXPECT_EQ(text.substr(member.offset, member.key.size() + 1), "\"" + member.key);
    checkOffsets(text, member.value);
  }
}

TEST(LocatedJson, every_value_knows_where_it_starts) {
  const std::string text = R"(  {"a": [1, -2.5e3, "x,:]}\"\\", true ,false,null],
    "b":{"c":{}, "d" : [ [ ] , [0] ]}, "e": "" })";
  Diagnostics diagnostics;
  const auto root = parseLocatedJson({text, "w.json"}, diagnostics);
  ASSERT_TRUE(root);
  checkOffsets(text, *root);
  EXPECT_EQ(root->find("a")->items[2].offset, text.find("\"x,"));
  EXPECT_EQ(root->find("a")->items[3].offset, text.find("true"));
  EXPECT_EQ(root->find("b")->find("d")->items[1].items[0].offset, text.find("0]"));
  EXPECT_EQ(root->find("e")->offset, text.find("\"\""));
}

TEST(LocatedJson, byte_order_mark_is_skipped) {
  const std::string text = "\xef\xbb\xbf{\"a\": 1}";
  Diagnostics diagnostics;
  const auto root = parseLocatedJson({text, "w.json"}, diagnostics);
  ASSERT_TRUE(root);
  EXPECT_EQ(root->offset, 3u);
  EXPECT_EQ(root->find("a")->offset, text.find('1'));
}

std::string syntaxErrorOf(const std::string& text) {
  Diagnostics diagnostics;
  EXPECT_FALSE(parseLocatedJson({text, "w.json"}, diagnostics));
  EXPECT_EQ(diagnostics.size(), 1u);
  return diagnostics.empty() ? "" : formatDiagnostic(diagnostics[0]);
}

TEST(LocatedJson, syntax_errors_point_at_the_place) {
  EXPECT_EQ(syntaxErrorOf("{\n  \"a\": 1,\n  \"a\": 2}"),
            "w.json:3:3: error: the key \"a\" is given twice\n"
            "    \"a\": 2}\n"
            "    ^");
  EXPECT_EQ(syntaxErrorOf("{\n  \"a\" 1}"),
            "w.json:2:7: error: syntax error while parsing object separator - unexpected number "
            "literal; expected ':'\n"
            "    \"a\" 1}\n"
            "        ^");
}

TEST(LocatedJson, numbers_too_large_for_a_double_are_errors) {
  EXPECT_EQ(syntaxErrorOf("{\"a\": 1e999}"),
            "w.json:1:11: error: number overflow parsing '1e999'\n"
            "  {\"a\": 1e999}\n"
            "            ^");
}

TEST(LocatedJson, nesting_is_limited) {
  EXPECT_NE(syntaxErrorOf(std::string(100000, '[')).find("nested deeper than 32 levels"),
            std::string::npos);
}

}  // namespace
}  // namespace orris
