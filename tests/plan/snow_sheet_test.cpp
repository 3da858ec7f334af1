#include <orris/plan/scene/snow_sheet.h>

#include <gtest/gtest.h>

namespace orris {
namespace {

TEST(SnowSheet, flakes_cover_about_a_hundredth) {
  const Image8 sheet = snowSheet();
  int flakes = 0;
  for (int y = 0; y < sheet.height; ++y)
    for (int x = 0; x < sheet.width; ++x) flakes += sheet.at(x, y)[3] != 0;
  const double share = double(flakes) / (sheet.width * sheet.height);
  EXPECT_GT(share, 0.005);
  EXPECT_LT(share, 0.012);
}

}  // namespace
}  // namespace orris
