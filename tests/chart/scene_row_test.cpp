#include <orris/chart/scenes/scene_row.h>

#include <gtest/gtest.h>

#include <cmath>

namespace orris {
namespace {

SceneRow rowOf(const char* setting, double square, double high, double ratio) {
  SceneRow row;
  row.scene = "random:3";
  row.setting = setting;
  row.bias[1].square = square;
  row.bias[1].squareInterval = {square, high};
  row.cost = {ratio, {ratio, ratio}, 1, 3};
  row.lag = 4;
  return row;
}

std::vector<double> stepAt(std::size_t changed, std::size_t late) {
  std::vector<double> brightness(changed + kLagFrames, 2);
  for (std::size_t i = 0; i < changed + late; ++i) brightness[i] = 1;
  return brightness;
}

TEST(SceneRow, lag_counts_frames_until_the_picture_stays_near_its_end) {
  EXPECT_EQ(lagOf(stepAt(16, 0), 16), 0);
  EXPECT_EQ(lagOf(stepAt(16, 20), 16), 20);
  std::vector<double> slow(16, 1);
  for (int i = 0; i < kLagFrames; ++i) slow.push_back(2 - std::pow(0.9, i));
  EXPECT_NEAR(lagOf(slow, 16), 19, 1);  // .9^19 = .135, eight frames from there on average .097
}

TEST(SceneRow, lag_is_unknown_where_the_lamp_is_lost_in_noise_or_nothing_settles) {
  EXPECT_EQ(lagOf(std::vector<double>(16 + kLagFrames, 1), 16), -1);
  std::vector<double> noisy = stepAt(16, 0);
  for (std::size_t i = 0; i < noisy.size(); ++i) noisy[i] += i % 2 == 0 ? 0.9 : -0.9;
  EXPECT_EQ(lagOf(noisy, 16), -1);
  std::vector<double> rising(16, 1);
  for (int i = 0; i < kLagFrames; ++i) rising.push_back(1 + i);
  EXPECT_EQ(lagOf(rising, 16), -1);
  EXPECT_EQ(lagOf({1, 1, 2}, 2), -1);
}

TEST(SceneRow, worst_channel_goes_by_the_upper_end_and_leaves_luminance_out) {
  SceneRow row;
  row.bias[0].squareInterval.high = 2e-4;
  row.bias[2].squareInterval.high = 5e-4;
  row.bias[3].squareInterval.high = 1;
  EXPECT_EQ(&worstChannel(row), &row.bias[2]);
}

TEST(SceneRow, table_shows_squares_below_zero_and_what_is_unknown) {
  SceneRow row = rowOf("GI_METHOD=A,B", -1e-4, 4e-4, 1.5);
  row.lag = -1;
  const std::string text = sceneRowsCsv({row});
  EXPECT_NE(text.find("\"random:3\",\"\",0,\"GI_METHOD=A,B\""), std::string::npos) << text;
  EXPECT_NE(text.find(",-0.01000,-0.01000,0.02000"), std::string::npos) << text;
  EXPECT_NE(text.find(",1.5000,1.5000,1.5000,,,,,,,-1,0.00\n"), std::string::npos) << text;
  const auto commas = [](std::string_view line) {
    bool quoted = false;
    int count = 0;
    for (const char c : line) {
      quoted ^= c == '"';
      count += c == ',' && !quoted;
    }
    return count;
  };
  const std::size_t end = text.find('\n');
  EXPECT_EQ(commas(text.substr(0, end)), commas(text.substr(end + 1)));
}

TEST(SceneRow, summary_takes_median_and_worst_and_marks_the_front) {
  const std::string text = sceneSummary({rowOf("good", 1e-4, 4e-4, 1.1), rowOf("bad", 1e-2, 4e-2, 1.2),
                                         rowOf("good", 9e-4, 1.6e-3, 1.3), rowOf("bad", 1e-2, 4e-2, 1.4)});
  const std::size_t good = text.find("* 0.020"), bad = text.find("  0.100");
  ASSERT_NE(good, std::string::npos) << text;
  ASSERT_NE(bad, std::string::npos) << text;
  EXPECT_NE(text.find("0.50 "), std::string::npos) << text;  // of two scenes one is within .03
  EXPECT_NE(text.find("good", good), std::string::npos) << text;
}

}  // namespace
}  // namespace orris
