#include <orris/glsl/tokens/token.h>

#include <gtest/gtest.h>

namespace orris {
namespace {

std::string joined(const std::string& text) {
  std::string result;
  for (const Token& token : tokenize(text)) result += (result.empty() ? "" : "|") + token.text;
  return result;
}

TEST(token, punctuators_are_as_long_as_possible) {
  EXPECT_EQ(joined("a<<=b>>c++-d&&!e^^f##g"), "a|<<=|b|>>|c|++|-|d|&&|!|e|^^|f|##|g");
}

TEST(token, numbers_keep_exponents_suffixes_and_hexadecimal) {
  EXPECT_EQ(joined("1.0e-3+.5f-0xE-1 1u 3.lf"), "1.0e-3|+|.5f|-|0xE|-|1|1u|3.lf");
  EXPECT_EQ(joined("a.x1.y"), "a|.|x1|.|y");
}

TEST(token, comments_are_tokens) {
  EXPECT_EQ(joined("a/*b*/c//d\ne"), "a|/*b*/|c|//d|e");
  EXPECT_EQ(tokenize("/*x")[0].kind, TokenKind::Comment);
}

TEST(token, bytes_outside_ascii_stay_together) { EXPECT_EQ(joined("a\xC3\xBC+"), "a|\xC3\xBC|+"); }

TEST(token, lines_columns_and_white_space_are_noted) {
  const std::vector<Token> tokens = tokenize("a\n\n  b c");
  ASSERT_EQ(tokens.size(), 3u);
  EXPECT_EQ(tokens[1].newlinesBefore, 2);
  EXPECT_EQ(tokens[1].origin.line, 3);
  EXPECT_EQ(tokens[1].origin.column, 3);
  EXPECT_TRUE(tokens[2].spaceBefore);
  EXPECT_FALSE(tokens[0].spaceBefore);
}

TEST(token, only_what_would_be_read_otherwise_glues) {
  const auto glues = [](const std::string& left, const std::string& right) {
    return wouldGlue(tokenize(left).at(0), tokenize(right).at(0));
  };
  EXPECT_TRUE(glues("-", "-"));
  EXPECT_TRUE(glues("a", "1"));
  EXPECT_TRUE(glues("1", ".5"));
  EXPECT_TRUE(glues("1e", "-"));
  EXPECT_TRUE(glues("<", "="));
  EXPECT_TRUE(glues("/", "/"));
  EXPECT_TRUE(glues("/", "*"));
  EXPECT_TRUE(glues(".", "5"));
  EXPECT_FALSE(glues("a", "("));
  EXPECT_FALSE(glues("(", "-"));
  EXPECT_FALSE(glues("=", "-"));
  EXPECT_FALSE(glues(".", "x"));
}

TEST(token, more_than_one_blank_line_prints_as_one) {
  TokenStream stream;
  stream.tokens = tokenize("a\n\n\n\nb");
  EXPECT_EQ(print(stream).text, "a\n\nb\n");
  EXPECT_EQ(print(TokenStream{}).text, "");
}

}  // namespace
}  // namespace orris
