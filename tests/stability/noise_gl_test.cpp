// The rays of a pixel: what they find, how noisy they are, and what averaging over frames leaves of it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

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

// Row B4 of docs/failure-modes.md.
// A mean over frames of weight a each keeps a / (2 - a) of their variance: 1/19 for a tenth.
TEST(PixelRays, weight_of_a_tenth_leaves_a_nineteenth_of_the_variance) {
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

TEST(PixelRays, still_camera_averages_independent_frames) {
  PackSession pack(kHalfLitWorld, {{"GI_METHOD", "BOUNCE_1"}, {"TEMPORAL_FRAMES", "64"}}, 96, 96);
  pack.renderFrames(1);
  const double once = relativeVariance(pack);
  pack.renderFrames(63);
  EXPECT_NEAR(relativeVariance(pack) * 64 / once, 1, .1);
}

// Row B5 of docs/failure-modes.md.
// Radiance is constant along a ray: a block within walls of lamps receives theirs, however far.
TEST(PixelRays, furnace_of_any_size_gives_the_radiance_of_its_walls) {
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

/// Mean over the pixels of their variance over frames, and of their mean, in red; their means.
struct Noise {
  double variance = 0, mean = 0;
  std::vector<double> means;
};

struct Drawn {
  std::string world = "cornell";
  int warmUp = 1, frames = 32;
};

Noise noiseOf(OptionValues options, const Drawn& drawn = {}) {
  constexpr int kSize = 24;
  options.insert({{"TEMPORAL_ACCUMULATION", "false"}, {"VOXEL_SIZE", "48"}});
  PackSession pack = PackSession::ofWorld(drawn.world, options, kSize, kSize);
  pack.renderFrames(drawn.warmUp);
  Noise noise;
  noise.means.resize(kSize * kSize);
  std::vector<double> squares(kSize * kSize);
  for (int frame = 0; frame < drawn.frames; ++frame) {
    pack.renderFrames(1);
    const ImageF image = pack.dump("colortex3");
    for (size_t i = 0; i < squares.size(); ++i) {
      const double value = image.pixels[i * image.channels];
      noise.means[i] += value / drawn.frames;
      squares[i] += value * value / drawn.frames;
    }
  }
  for (size_t i = 0; i < squares.size(); ++i) {
    noise.variance += (squares[i] - noise.means[i] * noise.means[i]) / double(squares.size());
    noise.mean += noise.means[i] / double(squares.size());
  }
  return noise;
}

// Row B1 of docs/failure-modes.md.
// It replaces light that further bounces would have found, without their noise.
TEST(PixelRays, floodfill_is_as_noisy_as_one_bounce) {
  const Noise one = noiseOf({{"GI_METHOD", "BOUNCE_1"}}),
              two = noiseOf({{"GI_METHOD", "BOUNCE_2"}}),
              flood = noiseOf({{"GI_METHOD", "FLOODFILL"}}, {.warmUp = 60});
  EXPECT_NEAR(flood.variance / one.variance, 1.07, .1);
  EXPECT_LT(flood.variance / two.variance, .85);
  EXPECT_GT(flood.mean, 1.3 * one.mean);
}

// Row B2 of docs/failure-modes.md.
// One frame of one bounce is nearer to what four bounces converge to than one frame of these; of means over many
// frames it is the other way round. So frames of one sample rank nothing.
TEST(PixelRays, more_bounces_win_only_after_many_frames) {
  const Drawn room{.world = "b_room", .frames = 192};
  const Noise one = noiseOf({{"GI_METHOD", "BOUNCE_1"}}, room);
  const Noise four = noiseOf({{"GI_METHOD", "BOUNCE_4"}}, room);
  double bias = -(one.variance + four.variance) / room.frames;  // its square
  for (size_t i = 0; i < one.means.size(); ++i)
    bias += std::pow(one.means[i] - four.means[i], 2) / double(one.means.size());
  EXPECT_LT(bias + one.variance, four.variance);
  EXPECT_GT(bias + one.variance / room.frames, four.variance / room.frames);
}

// Row B3 of docs/failure-modes.md.
// The lamp that rays find by chance, sampled: (3.16 / .35)^2 = 82 times less variance of one ray of each kind, 41 times less
// than of two that find it by chance; a choice among 4 of the lamp's 16 blocks leaves half of that.
TEST(PixelRays, rays_to_the_lamp_take_away_nearly_all_noise) {
  const Drawn room{.world = "b_room", .warmUp = 90, .frames = 64};
  const OptionValues cache = {{"GI_METHOD", "FACE_CACHE"}, {"GI_LAMPS", "HIT"}, {"GI_SAMPLES", "2"}};
  OptionValues sampled = cache;
  sampled["GI_LAMPS"] = "SAMPLED";
  const Noise hit = noiseOf(cache, room), aimed = noiseOf(sampled, room);
  EXPECT_NEAR(aimed.mean / hit.mean, 1, .1);
  EXPECT_GT(hit.variance / aimed.variance, 15);
}

}  // namespace
}  // namespace orris::test
