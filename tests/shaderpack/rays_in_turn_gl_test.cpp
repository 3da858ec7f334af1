// Rays into the hemisphere and rays to lamps, which share the samples of a pixel.
#include <gtest/gtest.h>

#include <string>

#include "pack_session.h"

namespace orris::test {
namespace {

// No multiples of the squares' sides.
constexpr int kWidth = 37, kHeight = 13;

/// A closed room whose samples are the pixel that they are of, and 2 n + 1 for the n-th to a lamp, 2 n for the others.
PackSession countingRoom(const std::string& block, const std::string& samples) {
  SessionSetup setup;
  setup.world = R"({"size": [9, 7, 9], "environment": {"time": 18000},
    "blocks": [{"hollow": "white_concrete", "min": [0, 0, 0], "max": [8, 6, 8]}, {"block": ")" + block + R"(", "at": [4, 6, 4]}],
    "cameras": [{"name": "eye", "position": [4.5, 3.5, 6.5], "yaw": 180, "pitch": 10}]})";
  setup.options = {{"GI_METHOD", "FACE_CACHE"}, {"GI_LAMPS", "SAMPLED"}, {"GI_SAMPLES", samples},
                   {"TEMPORAL_ACCUMULATION", "false"}, {"GI_FILTER", "false"}};
  setup.width = kWidth;
  setup.height = kHeight;
  setup.change = [](PackTexts& files) {
    setSamples(files, "vec4(vec2(pixel), 2.0 * float(number) + float(to_lamp), 1.0)");
  };
  return PackSession(setup);
}

struct Sample {
  int x, y;
  float count;
};

/// What the mean takes as the sample of a pixel; rows from the lowest on.
Sample sampleAt(const ImageF& light, int x, int y) {
  const float* texel = light.at(x, kHeight - 1 - y);
  return {int(texel[0]), int(texel[1]), texel[2]};
}

/// How many samples are before those of the frame, if each pixel has its own sample.
float countOfFrame(PackSession& pack, int squareSide) {
  pack.renderFrames(1);
  const ImageF light = pack.dump("colortex3");
  const float first = sampleAt(light, 0, 0).count;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const Sample sample = sampleAt(light, x, y);
      EXPECT_EQ(sample.x, x) << y;
      EXPECT_EQ(sample.y, y) << x;
      const int squares = squareSide > 0 ? x / squareSide + y / squareSide : 0;
      EXPECT_EQ(sample.count, first + float(squares)) << x << " " << y;
    }
  return first;
}

TEST(RaysInTurn, a_single_sample_is_of_each_kind_in_turn_over_frames_and_squares) {
  PackSession pack = countingRoom("glowstone", "1");
  const float first = countOfFrame(pack, 4);
  for (int frame = 1; frame < 4; ++frame) EXPECT_EQ(countOfFrame(pack, 4), first + float(frame));
}

TEST(RaysInTurn, two_samples_are_one_of_each_kind) {
  PackSession pack = countingRoom("glowstone", "2");
  const float first = countOfFrame(pack, 0);
  EXPECT_EQ(first - 2 * float(int(first) / 2), .5f) << "the mean of 2 n and 2 n + 1";
  EXPECT_EQ(countOfFrame(pack, 0), first + 2);
}

TEST(RaysInTurn, without_lamps_all_rays_go_into_the_hemisphere) {
  PackSession pack = countingRoom("white_concrete", "1");
  const float first = countOfFrame(pack, 0);
  EXPECT_EQ(int(first) % 2, 0);
  EXPECT_EQ(countOfFrame(pack, 0), first + 2);
}

}  // namespace
}  // namespace orris::test
