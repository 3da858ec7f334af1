#include <orris/glsl/tokens/source_map.h>

#include <gtest/gtest.h>

#include "glsl/glsl_test.h"

namespace orris {
namespace {

// Place of the n-th occurrence of `word` in the printed text, with its macro.
std::string placeOf(const MappedText& text, const std::string& word, int occurrence = 1) {
  std::size_t at = std::string::npos;
  for (int i = 0; i < occurrence; ++i) at = text.text.find(word, at + 1);
  if (at == std::string::npos) return "not found";
  int line = 1;
  std::size_t lineStart = 0;
  for (std::size_t i = 0; i < at; ++i) {
    if (text.text[i] == '\n') {
      ++line;
      lineStart = i + 1;
    }
  }
  const int column = static_cast<int>(at - lineStart) + 1;
  const SourceLocation place = text.locate(line, column);
  std::string result =
      place.file + ":" + std::to_string(place.line) + ":" + std::to_string(place.column);
  if (!text.macroAt(line, column).empty()) result += " " + std::string(text.macroAt(line, column));
  for (const SourceLocation& from : text.includedFrom(line, column)) {
    result += " < " + from.file + ":" + std::to_string(from.line);
  }
  return result;
}

MappedText mapped(const test::Files& files, const std::string& entry, bool rewriting = false) {
  Diagnostics diagnostics;
  TokenStream stream = preprocess(test::flatten(files, entry), {}, diagnostics);
  EXPECT_EQ(test::format(diagnostics), "");
  if (rewriting) rewrite(stream, Stage::Fragment);
  return print(stream);
}

TEST(source_map, plain_tokens_keep_line_and_column) {
  const MappedText text = mapped({{"/a.fsh", "\n#if 1\n  int a =  b;\n#endif\n"}}, "/a.fsh");
  EXPECT_EQ(placeOf(text, "int"), "/a.fsh:3:3");
  EXPECT_EQ(placeOf(text, "b"), "/a.fsh:3:12");
  EXPECT_EQ(placeOf(text, ";"), "/a.fsh:3:13");
}

TEST(source_map, tokens_after_a_continuation_know_their_line) {
  const MappedText text = mapped({{"/a.fsh", "int a = \\\n   b + /* x\n */ c;\n"}}, "/a.fsh");
  EXPECT_EQ(placeOf(text, "b"), "/a.fsh:2:4");
  EXPECT_EQ(placeOf(text, "c"), "/a.fsh:3:5");
}

TEST(source_map, macro_bodies_map_to_the_invocation_and_arguments_to_themselves) {
  const MappedText text =
      mapped({{"/a.fsh",
               "#define INNER(x) (inner * x)\n#define OUTER(x, y) INNER(x) + y + last\n"
               "float f =   OUTER(alpha,\n   INNER(beta));\nfloat g = g0;\n"}},
             "/a.fsh");
  EXPECT_EQ(placeOf(text, "inner"), "/a.fsh:3:13 OUTER");
  EXPECT_EQ(placeOf(text, "alpha"), "/a.fsh:3:19 OUTER");
  EXPECT_EQ(placeOf(text, "inner", 2), "/a.fsh:4:4 OUTER");
  EXPECT_EQ(placeOf(text, "beta"), "/a.fsh:4:10 OUTER");
  EXPECT_EQ(placeOf(text, "last"), "/a.fsh:3:13 OUTER");
  EXPECT_EQ(placeOf(text, "g0"), "/a.fsh:5:11");
}

TEST(source_map, includes_three_deep_give_the_whole_chain) {
  const MappedText text = mapped({{"/a.fsh", "int a;\n#include \"/b.glsl\"\nint z;\n"},
                                  {"/b.glsl", "\n#include \"/c.glsl\"\n"},
                                  {"/c.glsl", "int c;\n\n\n#include \"/d.glsl\"\n"},
                                  {"/d.glsl", "\n  int deep;\n"}},
                                 "/a.fsh");
  EXPECT_EQ(placeOf(text, "deep"), "/d.glsl:2:7 < /c.glsl:4 < /b.glsl:2 < /a.fsh:2");
  EXPECT_EQ(placeOf(text, "c;"), "/c.glsl:1:5 < /b.glsl:2 < /a.fsh:2");
  EXPECT_EQ(placeOf(text, "z"), "/a.fsh:3:5");
}

TEST(source_map, a_macro_of_an_include_maps_to_the_file_that_uses_it) {
  const MappedText text =
      mapped({{"/a.fsh", "#include \"/m.glsl\"\nint a = M;\n"}, {"/m.glsl", "\n#define M body\n"}},
             "/a.fsh");
  EXPECT_EQ(placeOf(text, "body"), "/a.fsh:2:9 M");
  ASSERT_EQ(text.macroOrigins.size(), 1u);
  EXPECT_EQ(locate(text.sites, text.macroOrigins[0]), (SourceLocation{"/m.glsl", 2, 1}));
}

TEST(source_map, places_survive_rewriting) {
  const MappedText text =
      mapped({{"/a.fsh",
               "#version 120\nvarying vec2 uv;\nuniform sampler2DShadow texture;\nvoid main() {\n"
               "  float s = shadow2D(texture, vec3(uv, after)).r; }\n"}},
             "/a.fsh", true);
  EXPECT_EQ(placeOf(text, "vec4("), "/a.fsh:5:13");
  EXPECT_EQ(placeOf(text, "gtexture", 2), "/a.fsh:5:22");
  EXPECT_EQ(placeOf(text, "after"), "/a.fsh:5:40");
  EXPECT_EQ(placeOf(text, "r;"), "/a.fsh:5:48");
  EXPECT_EQ(placeOf(text, "in "), "/a.fsh:2:1");
}

TEST(source_map, host_text_and_places_outside_have_no_location) {
  const MappedText text =
      mapped({{"/a.fsh", "#version 120\nvoid main() { int i = entityId; }\n"}}, "/a.fsh", true);
  EXPECT_EQ(placeOf(text, "uniform"), ":0:0");
  EXPECT_EQ(text.locate(0, 1), SourceLocation{});
  EXPECT_EQ(text.locate(99, 1), SourceLocation{});
  EXPECT_EQ(text.locate(4, 0), (SourceLocation{"/a.fsh", 2, 1}));
}

TEST(source_map, a_broken_site_table_does_not_loop) {
  const std::vector<IncludeSite> sites = {{"/a", 1, 1}, {"/b", 0, 2}};
  EXPECT_TRUE(includedFrom(sites, 0).empty());
  EXPECT_EQ(includedFrom(sites, 1).size(), 1u);
  EXPECT_TRUE(includedFrom(sites, 7).empty());
}

}  // namespace
}  // namespace orris
