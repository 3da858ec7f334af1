#include <orris/image/value_picture.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace orris {
namespace {

using Color = std::array<std::uint8_t, 3>;

ImageF rowOf(std::vector<float> values, int channels) {
  ImageF image(int(values.size()) / channels, 1, channels);
  image.pixels = std::move(values);
  return image;
}

Color colorAt(const Image8& image, int x) {
  const std::uint8_t* pixel = image.at(x, 0);
  return {pixel[0], pixel[1], pixel[2]};
}

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

TEST(ValuePicture, facts_leave_odd_values_out_of_the_extremes) {
  const ValueFacts facts = valueFacts(rowOf({1, -2, 5, kNan, kInf, 3, kNan, -kInf}, 2));
  EXPECT_EQ(facts.channels, 2);
  EXPECT_EQ(facts.low[0], 1);
  EXPECT_EQ(facts.high[0], 5);
  EXPECT_EQ(facts.low[1], -2);
  EXPECT_EQ(facts.high[1], 3);
  EXPECT_EQ(facts.nan, 2u);
  EXPECT_EQ(facts.infinite, 2u);
  EXPECT_EQ(facts.negative, 2u);  // -2 and -Inf
  EXPECT_EQ(valueFacts(rowOf({kNan}, 1)).high[0], 0);
}

TEST(ValuePicture, marks_beat_colours_and_only_of_what_is_shown) {
  const ImageF image = rowOf({kNan, 0, 0, 0, kInf, 0, 0, 0, -1, 0.5f, 1, -9}, 4);
  const Image8 all = paintValues(image, {.range = {{0, 1}}});
  EXPECT_EQ(colorAt(all, 0), (Color{255, 0, 255}));
  EXPECT_EQ(colorAt(all, 1), (Color{0, 255, 255}));
  EXPECT_EQ(colorAt(all, 2), (Color{0, 200, 60}));
  const Image8 plain = paintValues(image, {.range = {{0, 1}}, .markNegative = false});
  EXPECT_EQ(colorAt(plain, 2), (Color{0, 128, 255}));
  const Image8 blue = paintValues(image, {.channel = 2, .range = {{0, 1}}});
  EXPECT_EQ(colorAt(blue, 0), (Color{0, 0, 0}));
  EXPECT_EQ(colorAt(blue, 2), (Color{255, 255, 255}));
}

TEST(ValuePicture, own_range_leaves_single_outliers_out) {
  std::vector<float> values(1000, 0.0f);
  for (int i = 0; i < 1000; ++i) values[std::size_t(i)] = float(i) / 1000;
  values[500] = 1e9f;
  const auto [low, high] = paintedRange(rowOf(values, 1), {});
  EXPECT_NEAR(low, 0.005, 1e-3);
  EXPECT_NEAR(high, 0.995, 2e-3);
  const auto constant = paintedRange(rowOf({3, 3, 3}, 1), {});
  EXPECT_EQ(constant, std::pair(0.0f, 3.0f));
  EXPECT_EQ(paintedRange(rowOf({kNan}, 1), {}), std::pair(0.0f, 1.0f));
}

TEST(ValuePicture, false_colours_get_lighter) {
  double before = -1;
  for (int i = 0; i <= 100; ++i) {
    const Color color = falseColor(float(i) / 100);
    const double light = 0.2126 * color[0] + 0.7152 * color[1] + 0.0722 * color[2];
    EXPECT_GT(light, before) << i;
    before = light;
  }
  EXPECT_EQ(falseColor(-5), falseColor(0));
  EXPECT_EQ(falseColor(5), falseColor(1));
}

}  // namespace
}  // namespace orris
