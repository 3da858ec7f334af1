#include "image/encode_png.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "core/replace_file.h"

namespace orris {
namespace {

Image16 ramp() {
  Image16 image(5, 3, 4);
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i] = std::uint16_t(i * 1091 + 7);
  for (int c = 0; c < 4; ++c) image.at(0, 0)[c] = std::uint16_t(c == 3 ? 0 : 40000);  // clear, of a colour
  return image;
}

TEST(EncodePng, sixteen_bits_come_back_also_under_alpha_zero) {
  const Image16 image = ramp();
  Diagnostics diagnostics;
  const auto bytes = encodePng(image, "atlas", diagnostics);
  ASSERT_TRUE(bytes && diagnostics.empty());
  const std::string path = testing::TempDir() + "orris-png-" + std::to_string(getpid()) + ".png";
  ASSERT_FALSE(replaceFile(path, *bytes));
  const auto read = readImage(path, diagnostics);
  std::filesystem::remove(path);
  ASSERT_TRUE(read);
  ASSERT_EQ(read->pixels.size(), image.pixels.size());
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    EXPECT_NEAR(read->pixels[i] * 65535, image.pixels[i], 0.01) << i;
}

TEST(EncodePng, the_same_pixels_give_the_same_bytes) {
  Diagnostics diagnostics;
  EXPECT_EQ(encodePng(ramp(), "a", diagnostics), encodePng(ramp(), "b", diagnostics));
}

}  // namespace
}  // namespace orris
