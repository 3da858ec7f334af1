#include <orris/check/matrix/covering_array.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <set>

namespace orris {
namespace {

void expectAllPairs(const std::vector<int>& levels) {
  const auto rows = pairwiseRows(levels);
  for (std::size_t a = 0; a < levels.size(); ++a) {
    for (std::size_t b = a + 1; b < levels.size(); ++b) {
      std::set<std::pair<int, int>> seen;
      for (const auto& row : rows) seen.emplace(row[a], row[b]);
      EXPECT_EQ(seen.size(), static_cast<std::size_t>(levels[a] * levels[b])) << a << " " << b;
    }
  }
}

TEST(CoveringArray, every_pair_of_values_occurs) {
  expectAllPairs({2, 2});
  expectAllPairs({3, 2, 4, 2, 2, 5});
  expectAllPairs(std::vector<int>(60, 2));
}

TEST(CoveringArray, has_few_rows) {
  EXPECT_LE(pairwiseRows(std::vector<int>(60, 2)).size(), 14u);
  EXPECT_LE(pairwiseRows({3, 3, 3, 3}).size(), 13u);
  EXPECT_EQ(pairwiseRows({7, 5}).size(), 35u);
}

TEST(CoveringArray, one_factor_and_none) {
  EXPECT_EQ(pairwiseRows({3}), (std::vector<std::vector<int>>{{0}, {1}, {2}}));
  EXPECT_TRUE(pairwiseRows({}).empty());
}

TEST(CoveringArray, is_the_same_each_time) {
  EXPECT_EQ(pairwiseRows({3, 2, 4, 2}), pairwiseRows({3, 2, 4, 2}));
}

}  // namespace
}  // namespace orris
