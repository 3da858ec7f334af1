#include <orris/image/image_compare.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace orris {
namespace {

ImageF filled(int width, int height, int channels, float value) {
  ImageF image(width, height, channels);
  for (float& pixel : image.pixels) pixel = value;
  return image;
}

ImageDifference compared(const ImageF& image, const ImageF& reference, float threshold = 0.1f) {
  Diagnostics diagnostics;
  const auto result = compareImages(image, reference, threshold, diagnostics);
  EXPECT_TRUE(result);
  EXPECT_TRUE(diagnostics.empty());
  return result.value_or(ImageDifference{});
}

TEST(ImageCompare, equal_images_differ_by_nothing) {
  ImageF image(20, 16, 3);
  for (size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = float(i % 17) / 16;
  const ImageDifference result = compared(image, image);
  EXPECT_EQ(result.rmse, 0);
  EXPECT_EQ(result.relMse, 0);
  EXPECT_EQ(result.maxAbsolute, 0);
  EXPECT_EQ(result.fractionAbove, 0);
  EXPECT_NEAR(result.ssim, 1, 1e-12);
}

TEST(ImageCompare, constant_offset_by_hand) {
  // Every channel off by 0.5 at a reference of 0.25: relMse is 0.25 / (0.0625 + 0.01).
  const ImageDifference result = compared(filled(12, 12, 3, 0.75f), filled(12, 12, 3, 0.25f));
  EXPECT_NEAR(result.rmse, 0.5, 1e-9);
  EXPECT_NEAR(result.relMse, 0.25 / 0.0725, 1e-6);
  EXPECT_NEAR(result.maxAbsolute, 0.5, 1e-9);
  EXPECT_EQ(result.fractionAbove, 1);
  // No variance: only the luminance term of the index is left.
  EXPECT_NEAR(result.ssim, (2 * 0.75 * 0.25 + 1e-4) / (0.75 * 0.75 + 0.25 * 0.25 + 1e-4), 1e-6);
}

TEST(ImageCompare, one_channel_of_one_pixel_by_hand) {
  const ImageF reference = filled(4, 2, 3, 0);
  ImageF image = reference;
  image.at(3, 1)[1] = 0.6f;
  const ImageDifference result = compared(image, reference);
  EXPECT_NEAR(result.rmse, std::sqrt(0.36 / 24), 1e-7);
  EXPECT_NEAR(result.relMse, 0.36 / 0.01 / 24, 1e-5);
  EXPECT_NEAR(result.maxAbsolute, 0.6, 1e-6);
  EXPECT_DOUBLE_EQ(result.fractionAbove, 1.0 / 8);
  EXPECT_DOUBLE_EQ(compared(image, reference, 0.7f).fractionAbove, 0);
}

TEST(ImageCompare, relative_error_is_relative_to_the_second_image) {
  const ImageF low = filled(2, 2, 1, 0.1f), high = filled(2, 2, 1, 1);
  EXPECT_NEAR(compared(high, low).relMse, 0.81 / 0.02, 1e-4);
  EXPECT_NEAR(compared(low, high).relMse, 0.81 / 1.01, 1e-6);
}

TEST(ImageCompare, similarity_of_opposite_patterns_is_negative) {
  ImageF checker(16, 16, 1), inverse(16, 16, 1);
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 16; ++x) {
      *checker.at(x, y) = float((x + y) % 2);
      *inverse.at(x, y) = 1 - *checker.at(x, y);
    }
  }
  // Means 1/2, variances 1/4 and covariance -1/4 in every window, up to the window's own balance.
  const double expected = (0.5 + 1e-4) * (-0.5 + 9e-4) / ((0.5 + 1e-4) * (0.5 + 9e-4));
  EXPECT_NEAR(compared(checker, inverse).ssim, expected, 1e-3);
}

TEST(ImageCompare, similarity_of_one_window_by_hand) {
  // One 11x11 window with a single lit texel in its middle, whose weight is w = g(0)^2.
  ImageF image = filled(11, 11, 1, 0);
  const ImageF reference = image;
  *image.at(5, 5) = 1;
  double sum = 0;
  for (int i = -5; i <= 5; ++i) sum += std::exp(-i * i / 4.5);
  const double w = 1 / (sum * sum);
  const double expected = 1e-4 * 9e-4 / ((w * w + 1e-4) * (w - w * w + 9e-4));
  EXPECT_NEAR(compared(image, reference).ssim, expected, 1e-9);
}

TEST(ImageCompare, alpha_does_not_count) {
  ImageF image = filled(3, 3, 4, 0.5f), reference = filled(3, 3, 3, 0.5f);
  for (int i = 0; i < 9; ++i) image.pixels[size_t(i) * 4 + 3] = 0;
  EXPECT_EQ(compared(image, reference).maxAbsolute, 0);
}

TEST(ImageCompare, not_a_number_is_an_infinite_error) {
  const ImageF reference = filled(3, 3, 3, 0.5f);
  ImageF image = reference;
  image.pixels[4] = std::numeric_limits<float>::quiet_NaN();
  const ImageDifference result = compared(image, reference);
  EXPECT_TRUE(std::isinf(result.rmse));
  EXPECT_EQ(result.fractionAbove, 1);
  EXPECT_EQ(result.ssim, 0);
}

TEST(ImageCompare, different_sizes_are_a_diagnostic) {
  Diagnostics diagnostics;
  EXPECT_FALSE(compareImages(filled(3, 3, 3, 0), filled(3, 4, 4, 0), 0, diagnostics));
  ASSERT_EQ(diagnostics.size(), 1u);
  EXPECT_EQ(diagnostics[0].message,
            "the images cannot be compared: 3x3 with 3 colour channels against 3x4 with 3 colour "
            "channels");
}

TEST(ImageCompare, difference_picture_is_absolute_and_scaled) {
  ImageF image = filled(1, 1, 4, 0), reference = filled(1, 1, 3, 0);
  image.pixels = {0.25f, 0.5f, 0, 0};
  reference.pixels = {0.5f, 0.25f, 0};
  const ImageF difference = differenceImage(image, reference, 4);
  EXPECT_EQ(difference.pixels, (std::vector<float>{1, 1, 0, 1}));
}

}  // namespace
}  // namespace orris
