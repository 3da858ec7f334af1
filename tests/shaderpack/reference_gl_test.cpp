// Global illumination against stored pictures of the path tracer: sun and sky through windows,
// daylight deep in a hall, a lamp round a corner, a cave with lava, stained windows; and BOUNCE_N
// against light that is cut off after as many rays. The pictures are traced once
// (references/make.sh), so that a mistake in what pack and tracer share shows as well.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <orris/chart/measure/reference_picture.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "pack_session.h"

namespace orris::test {
namespace {

struct View {
  const char* name;  ///< of the test
  const char* world;
  std::size_t camera;
  const char* picture;
  const char* method;
  int samples;  ///< of a frame, which costs more than its rays; but light needs frames to spread in a cache
  double mean;  ///< limit of the relative error of the mean, by channel
  double rms;   ///< limit of that of parts of the picture, by channel; holds the frames' noise
};
void PrintTo(const View& view, std::ostream* out) { *out << view.name; }

/// Rays of a pixel over all frames.
constexpr int kRays = 384;

ImageF drawn(const View& view) {
  PackSession pack = PackSession::ofWorld(view.world,
                                          {{"GI_METHOD", view.method},
                                           {"GI_LAMPS", "SAMPLED"},
                                           {"GI_SAMPLES", std::to_string(view.samples)},
                                           {"GI_FILTER", "false"},
                                           {"TEMPORAL_FRAMES", "1024"},
                                           {"AMBIENT_MINIMUM", "0.0"},
                                           {"DIRECT_LIGHT", "NONE"}},
                                          16, 9, view.camera);
  pack.renderFrames(kRays / view.samples);
  return toRgb(pack.dump("colortex0"));
}

/// Relative errors of one channel, over pixels that are no edges.
struct Errors {
  double mean = 0;  ///< with its sign
  double rms = 0;   ///< of the means of kBlocks parts of the picture, in which noise is smaller
};
constexpr int kBlocksAcross = 4, kBlocksDown = 3, kBlocks = kBlocksAcross * kBlocksDown;

/// Which part of the picture a pixel belongs to.
std::size_t blockOf(const ImageF& picture, std::size_t pixel) {
  const int x = int(pixel) % picture.width, y = int(pixel) / picture.width;
  return std::size_t(x * kBlocksAcross / picture.width +
                     kBlocksAcross * (y * kBlocksDown / picture.height));
}

Errors errorsOf(const ImageF& picture, const ReferencePicture& reference, std::size_t channel) {
  double brightness = 0;
  const std::size_t pixels = picture.pixels.size() / 3;
  for (std::size_t i = 0; i < pixels; ++i)
    brightness += reference.mean.pixels[i * 3 + channel] / double(pixels);
  // Against each half, so that the noise of the reference is not in the product.
  std::array<std::array<double, 2>, kBlocks> sums{};
  std::array<double, kBlocks> counts{};
  for (std::size_t i = 0; i < pixels; ++i) {
    if (!reference.edges.empty() && reference.edges[i] != 0) continue;
    const std::size_t value = i * 3 + channel, block = blockOf(picture, i);
    const double scale = reference.mean.pixels[value] + 0.1 * brightness;
    sums[block][0] += (picture.pixels[value] - reference.first.pixels[value]) / scale;
    sums[block][1] += (picture.pixels[value] - reference.second.pixels[value]) / scale;
    ++counts[block];
  }
  double total = 0, sum = 0, squares = 0;
  for (std::size_t block = 0; block < kBlocks; ++block) {
    if (counts[block] == 0) continue;
    total += counts[block];
    sum += (sums[block][0] + sums[block][1]) / 2;
    squares += sums[block][0] * sums[block][1] / counts[block];
  }
  return {sum / total, std::sqrt(std::max(0.0, squares / total))};
}

class Reference : public testing::TestWithParam<View> {};

TEST_P(Reference, is_what_the_method_draws) {
  const View& view = GetParam();
  Diagnostics diagnostics;
  const auto reference = readReference(
      fmt::format(ORRIS_SOURCE_DIR "/tests/shaderpack/references/{}.exr", view.picture),
      diagnostics);
  ASSERT_TRUE(reference && reference->hasHalves);
  const ImageF picture = drawn(view);
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const Errors errors = errorsOf(picture, *reference, channel);
    RecordProperty(fmt::format("errors{}", channel),
                   fmt::format("{:.4f} {:.4f}", errors.mean, errors.rms));
    EXPECT_NEAR(errors.mean, 0, view.mean) << "channel " << channel << ", rms " << errors.rms;
    EXPECT_LT(errors.rms, view.rms) << "channel " << channel;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Views, Reference,
    testing::Values(View{"house", "h4_house", 1, "h4_house", "FACE_CACHE", 4, .03, .06},
                    View{"hall", "deep_hall", 1, "deep_hall", "FACE_CACHE", 8, .02, .07},
                    View{"bend", "bend_grey", 0, "bend_grey", "FACE_CACHE", 8, .02, .03},
                    View{"cave", "lava_cave", 1, "lava_cave", "FACE_CACHE", 4, .05, .06},
                    View{"chapel", "chapel", 0, "chapel", "FACE_CACHE", 8, .05, .08},
                    View{"two_bounces", "h4_house", 1, "h4_house_2", "BOUNCE_2", 32, .035, .09},
                    View{"four_bounces", "h4_house", 1, "h4_house_4", "BOUNCE_4", 32, .035, .09},
                    View{"one_bounce", "h4_house", 1, "h4_house_1", "BOUNCE_1", 32, .035, .09},
                    View{"floodfill", "h4_house", 1, "h4_house", "FLOODFILL", 8, .4, .45}),
    [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace orris::test
