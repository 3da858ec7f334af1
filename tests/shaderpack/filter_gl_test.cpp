// What the smoothing passes take of gathered light, and what they leave.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "pack_session.h"

namespace orris::test {
namespace {

/// Pictures of light that the rays of a few frames gather.
class GatheredLight {
 public:
  GatheredLight(const char* world, std::size_t camera) : world_(world), camera_(camera) {}
  std::vector<float> drawn(int frames, OptionValues changes) const {
    return drawnAt({frames}, std::move(changes)).front();
  }
  /// After each of these numbers of frames, which rise.
  std::vector<std::vector<float>> drawnAt(const std::vector<int>& frames,
                                          OptionValues changes) const {
    changes.insert({{"GI_METHOD", "FACE_CACHE"}, {"AMBIENT_MINIMUM", "0.0"}});
    PackSession pack = PackSession::ofWorld(world_, changes, 64, 36, camera_);
    std::vector<std::vector<float>> pictures;
    int drawn = 0;
    for (const int frame : frames) {
      pack.renderFrames(frame - drawn);
      drawn = frame;
      std::vector<float>& light = pictures.emplace_back();
      const ImageF picture = pack.dump("colortex0");
      for (std::size_t i = 0; i < picture.pixels.size(); ++i)
        if (i % 4 != 3) light.push_back(picture.pixels[i]);
    }
    return pictures;
  }
  /// Rms over pixels and channels, relative to the light of each.
  static double difference(const std::vector<float>& light, const std::vector<float>& exact) {
    double sum = 0;
    for (std::size_t i = 0; i < light.size(); ++i) {
      const double off = (light[i] - exact[i]) / (exact[i] + 1e-5);
      sum += off * off / double(light.size());
    }
    return std::sqrt(sum);
  }

 private:
  const char* world_;
  std::size_t camera_;
};

// Round the corner from a lamp light falls to a tenth within the 15 pixels that the filter mixes.
TEST(GiFilter, leaves_what_is_no_noise) {
  const GatheredLight corridor("bend_grey", 1);
  const auto exact = corridor.drawn(160, {{"GI_FILTER", "false"}, {"GI_SAMPLES", "16"}});
  const auto filtered = corridor.drawn(60, {}),
             noisy = corridor.drawn(60, {{"GI_FILTER", "false"}});
  EXPECT_LT(GatheredLight::difference(filtered, exact),
            .5 * GatheredLight::difference(noisy, exact));
}

// Light behind stained glass differs from what is beside it in colour, and little in luminance.
TEST(GiFilter, leaves_edges_of_color) {
  const GatheredLight chapel("chapel", 0);
  const auto unfiltered = chapel.drawn(100, {{"GI_FILTER", "false"}}),
             filtered = chapel.drawn(100, {});
  EXPECT_LT(GatheredLight::difference(filtered, unfiltered), 1);
}

// The longer a mean, the less of a difference beside it is noise.
TEST(GiFilter, fades_as_means_grow) {
  const GatheredLight hall("h6_hall", 0);
  const auto unfiltered = hall.drawn(100, {{"GI_FILTER", "false"}});
  const auto filtered = hall.drawn(100, {});
  EXPECT_LT(GatheredLight::difference(filtered, unfiltered), .29);
}

// Pixels at the edge of a face have others on one side of them alone, whose light is another.
TEST(GiFilter, keeps_the_slope_of_light_at_edges) {
  const GatheredLight hut("snow_hut", 1);
  const auto exact = hut.drawn(100, {{"GI_FILTER", "false"}, {"GI_SAMPLES", "16"}});
  const auto filtered = hut.drawn(100, {}), noisy = hut.drawn(100, {{"GI_FILTER", "false"}});
  const double share =
      GatheredLight::difference(filtered, exact) / GatheredLight::difference(noisy, exact);
  RecordProperty("share", std::to_string(share));
  EXPECT_LT(share, .6);
}

// Where light comes from a small opening far off, few rays find it, and the last ones of a long mean say little of its noise.
TEST(GiFilter, knows_the_noise_of_light_that_is_seldom_found) {
  const std::vector<std::vector<float>> light =
      GatheredLight("deep_hall", 0).drawnAt({400, 500}, {});
  const double change = GatheredLight::difference(light[0], light[1]);
  RecordProperty("change", std::to_string(change));
  EXPECT_LT(change, .2);
}

TEST(GiFilter, takes_most_of_the_noise_and_no_light) {
  const GatheredLight room("cornell", 0);
  const auto exact = room.drawn(160, {{"GI_FILTER", "false"}, {"GI_SAMPLES", "16"}});
  const auto filtered = room.drawn(4, {}), noisy = room.drawn(4, {{"GI_FILTER", "false"}});
  EXPECT_LT(GatheredLight::difference(filtered, exact),
            .35 * GatheredLight::difference(noisy, exact));
  const auto sum = [](const std::vector<float>& light) {
    return std::accumulate(light.begin(), light.end(), 0.0);
  };
  EXPECT_NEAR(sum(filtered) / sum(noisy), 1, .015);
}

}  // namespace
}  // namespace orris::test
