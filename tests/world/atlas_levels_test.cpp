#include <orris/world/atlas/atlas_levels.h>

#include <gtest/gtest.h>

#include <cmath>

namespace orris {
namespace {

/// Rows of 0 and 255, one below the other.
Image8 stripes(int size) {
  Image8 image(size, size, 4);
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x)
      for (int c = 0; c < 4; ++c) image.at(x, y)[c] = y % 2 == 0 ? 255 : 0;
  return image;
}

TEST(AtlasLevels, HalfTheLightIsHalfTheLight) {
  const auto levels = atlasLevels(stripes(16), kAtlasLevels);
  ASSERT_EQ(levels.size(), 5u);
  const int half = int(std::lround(255 * std::pow(0.5, 1 / 2.2)));
  for (std::size_t i = 1; i < levels.size(); ++i) {
    EXPECT_EQ(levels[i].width, 16 >> i);
    EXPECT_NEAR(levels[i].at(0, 0)[1], half, 1) << i;
    EXPECT_EQ(levels[i].at(0, 0)[3], 128) << i;
  }
}

TEST(AtlasLevels, AnEvenColourStaysAsItIs) {
  Image8 image(8, 4, 4);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = std::uint8_t(40 + i % 4);
  const auto levels = atlasLevels(image, 4);
  EXPECT_EQ(levels[3].width, 1);
  EXPECT_EQ(levels[3].height, 1);
  for (int c = 0; c < 4; ++c) EXPECT_EQ(levels[3].at(0, 0)[c], 40 + c);
}

}  // namespace
}  // namespace orris
