// The rays of a pixel: what they find, how noisy they are, and what averaging over frames leaves of it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "../shaderpack/pack_session.h"

namespace orris::test {
namespace {

// A floor under a lamp that fills half of the ceiling: rays find it about every other time.
const char* const kHalfLitWorld = R"({
  "size": [9, 4, 9],
  "blocks": [{"hollow": "stone", "min": [0, 0, 0], "max": [8, 3, 8]},
             {"box": "glowstone", "min": [0, 3, 0], "max": [4, 3, 8]}],
  "cameras": [{"name": "eye", "position": [4.5, 2.5, 4.5], "yaw": 0, "pitch": 90, "fov": 8}],
  "environment": {"time": 18000}
})";

/// Variance over the pixels of the gathered light, in squares of its mean.
double relativeVariance(PackSession& pack) {
  const ImageF image = pack.dump("colortex3");
  double sum = 0, squares = 0;
  const int count = image.width * image.height;
  for (int i = 0; i < count; ++i) {
    const double value = image.pixels[static_cast<size_t>(i) * image.channels];
    sum += value;
    squares += value * value;
  }
  return squares * count / (sum * sum) - 1;
}

// A mean over frames of weight a each keeps a / (2 - a) of their variance: 1/19 for a tenth.
TEST(B4, weight_of_a_tenth_leaves_a_nineteenth_of_the_variance) {
  PackSession pack(kHalfLitWorld, {{"GI_METHOD", "BOUNCE_1"}, {"TEMPORAL_FRAMES", "10"}}, 96, 96);
  pack.renderFrames(1);
  const double once = relativeVariance(pack);
  pack.renderFrames(63);
  double left = 0;
  for (int i = 0; i < 4; ++i) {
    pack.renderFrames(16);
    left += relativeVariance(pack) / 4;
  }
  EXPECT_NEAR(left / once / .0526, 1, .05);
}

TEST(B4, still_camera_averages_independent_frames) {
  PackSession pack(kHalfLitWorld, {{"GI_METHOD", "BOUNCE_1"}, {"TEMPORAL_FRAMES", "64"}}, 96, 96);
  pack.renderFrames(1);
  const double once = relativeVariance(pack);
  pack.renderFrames(63);
  EXPECT_NEAR(relativeVariance(pack) * 64 / once, 1, .1);
}

// Radiance is constant along a ray: a block within walls of lamps receives theirs, however far.
TEST(B5, furnace_of_any_size_gives_the_radiance_of_its_walls) {
  for (const int size : {5, 25}) {
    const std::string world = fmt::format(R"({{
      "size": [{0}, {0}, {0}],
      "blocks": [{{"hollow": "glowstone", "min": [0, 0, 0], "max": [{1}, {1}, {1}]}},
                 {{"box": "stone", "min": [{2}, {2}, {2}], "max": [{2}, {2}, {2}]}}],
      "cameras": [{{"name": "eye", "position": [{2}.5, {2}.5, {3}.9], "yaw": 180, "fov": 8}}],
      "environment": {{"time": 18000}}
    }})",
                                          size, size - 1, size / 2, size / 2 + 1);
    PackSession pack(world, {{"GI_METHOD", "BOUNCE_1"}, {"EMISSION_STRENGTH", "16.0"}});
    pack.renderFrames(1);
    const ImageF radiance = pack.dump("colortex3");
    for (int i = 0; i < radiance.width * radiance.height; ++i)
      ASSERT_NEAR(radiance.pixels[static_cast<size_t>(i) * radiance.channels], 16, .16) << size;
  }
}

/// Mean over the pixels of their variance over frames, and of their mean, in red.
struct Noise {
  double variance = 0, mean = 0;
};

Noise noiseOf(const std::string& method) {
  constexpr int kFrames = 32, kSize = 24;
  PackSession pack = PackSession::ofWorld(
      "cornell", {{"GI_METHOD", method}, {"TEMPORAL_ACCUMULATION", "false"}, {"VOXEL_SIZE", "48"}},
      kSize, kSize);
  pack.renderFrames(method == "FLOODFILL" ? 60 : 1);
  std::vector<double> sums(kSize * kSize), squares(kSize * kSize);
  for (int frame = 0; frame < kFrames; ++frame) {
    pack.renderFrames(1);
    const ImageF image = pack.dump("colortex3");
    for (size_t i = 0; i < sums.size(); ++i) {
      const double value = image.pixels[i * image.channels];
      sums[i] += value / kFrames;
      squares[i] += value * value / kFrames;
    }
  }
  Noise noise;
  for (size_t i = 0; i < sums.size(); ++i) {
    noise.variance += (squares[i] - sums[i] * sums[i]) / static_cast<double>(sums.size());
    noise.mean += sums[i] / static_cast<double>(sums.size());
  }
  return noise;
}

// It replaces light that further bounces would have found, without their noise.
TEST(B1, floodfill_is_as_noisy_as_one_bounce) {
  const Noise one = noiseOf("BOUNCE_1"), two = noiseOf("BOUNCE_2"), flood = noiseOf("FLOODFILL");
  EXPECT_NEAR(flood.variance / one.variance, 1.07, .1);
  EXPECT_LT(flood.variance / two.variance, .85);
  EXPECT_GT(flood.mean, 1.3 * one.mean);
}

}  // namespace
}  // namespace orris::test
