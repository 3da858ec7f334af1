// What settles and what does not: pictures of 64x64 pixels, each of twice as many frames as the one before.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include <orris/image/picture_settling.h>

namespace orris {
namespace {

constexpr int kSide = 64;

/// The number of frames after which a picture settles, 0: not in 512. `pixel` is 0 to 1.
int framesUntilSettled(const std::function<double(int x, int y, int frames)>& pixel) {
  PictureSettling settling;
  for (int frames = PictureSettling::kFirstLook; frames <= 512; frames *= 2) {
    Image8 picture(kSide, kSide, 3);
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x)
        for (int c = 0; c < 3; ++c)
          picture.at(x, y)[c] = std::uint8_t(std::lround(std::clamp(pixel(x, y, frames), 0.0, 1.0) * 255));
    if (settling.settles(picture)) return frames;
  }
  return 0;
}

TEST(PictureSettling, what_stands_still_settles_at_the_second_look) {
  EXPECT_EQ(framesUntilSettled([](int x, int, int) { return x / double(kSide); }), 16);
}

TEST(PictureSettling, an_exposure_that_adapts_settles_when_it_is_there) {
  const auto exposed = [](double frames) {
    return framesUntilSettled([frames](int x, int, int n) {
      return x / double(kSide) * (1 - 0.5 * std::exp(-n / frames));
    });
  };
  EXPECT_EQ(exposed(4), 64);
  EXPECT_EQ(exposed(20), 256);
  EXPECT_EQ(exposed(200), 0);
}

TEST(PictureSettling, a_mean_of_noise_settles_when_no_noise_is_seen) {
  // The mean of n frames: its noise falls with the root of n, and all of it is drawn anew each time.
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0, 1);
  const auto mean = [&](double deviation) {
    return framesUntilSettled([&, deviation](int, int, int n) {
      return 0.5 + deviation * noise(random) / std::sqrt(n);
    });
  };
  EXPECT_EQ(mean(0.05), 16);
  EXPECT_EQ(mean(0.15), 128);
  EXPECT_EQ(mean(0.6), 0);
}

TEST(PictureSettling, waves_that_go_on_for_ever_do_not_count) {
  const int frames = framesUntilSettled([](int x, int y, int n) {
    return 0.5 + 0.2 * std::sin(x * 0.3 + n * 1.7) * std::cos(y * 0.2 + n * 0.9);
  });
  EXPECT_GE(frames, 16);
  EXPECT_LE(frames, 128);
}

TEST(PictureSettling, waves_do_not_hide_an_exposure_that_adapts) {
  EXPECT_GE(framesUntilSettled([](int x, int y, int n) {
              return (0.5 + 0.2 * std::sin(x * 0.3 + n * 1.7) * std::cos(y * 0.2 + n * 0.9)) *
                     (1 - 0.5 * std::exp(-n / 40.0));
            }),
            256);
}

}  // namespace
}  // namespace orris
