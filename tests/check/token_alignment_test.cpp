#include <orris/check/logs/token_alignment.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace orris {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Each character is a token.
std::vector<int> align(std::string_view from, std::string_view to) {
  const auto split = [](std::string_view text) {
    std::vector<std::string_view> tokens;
    for (std::size_t i = 0; i < text.size(); ++i) tokens.push_back(text.substr(i, 1));
    return tokens;
  };
  return alignTokens(split(from), split(to));
}

TEST(AlignTokens, equalTextsMatchThroughout) {
  EXPECT_THAT(align("abcabc", "abcabc"), ElementsAre(0, 1, 2, 3, 4, 5));
}

TEST(AlignTokens, addedTokensMatchNothing) {
  EXPECT_THAT(align("xxabycd", "abcd"), ElementsAre(-1, -1, 0, 1, -1, 2, 3));
}

TEST(AlignTokens, removedTokensAreStepped) { EXPECT_THAT(align("ad", "abcd"), ElementsAre(0, 3)); }

TEST(AlignTokens, aRenamedTokenLeavesItsNeighboursMatched) {
  EXPECT_THAT(align("abXde", "abcde"), ElementsAre(0, 1, -1, 3, 4));
}

TEST(AlignTokens, movedTextMatchesOnceAndRises) {
  const std::vector<int> matched = align("12345abcdefgh", "abcdefgh12345");
  EXPECT_THAT(matched, ElementsAre(-1, -1, -1, -1, -1, 0, 1, 2, 3, 4, 5, 6, 7));
}

TEST(AlignTokens, emptyTexts) {
  EXPECT_THAT(align("", ""), IsEmpty());
  EXPECT_THAT(align("ab", ""), ElementsAre(-1, -1));
}

TEST(AlignTokens, aLongTextOfOneTokenIsNoTrouble) {
  const std::string many(200000, 'a');
  EXPECT_EQ(align(many, many).size(), many.size());
}

}  // namespace
}  // namespace orris
