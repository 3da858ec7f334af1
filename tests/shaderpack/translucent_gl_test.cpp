// Glass and water by rays of their own: one surface a pixel has a mean over frames, the nearest. How right the light
// is: reference_gl_test.cpp.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include <orris/render/inspect/counters.h>
#include "pack_session.h"

namespace orris::test {
namespace {

constexpr int kAcross = 16;
constexpr float kExpectedFrames = 16;  // program/gbuffers/translucent.glsl

/// A room with a lamp, and in it so many panes of glass one behind another that fill the view.
std::string glassRoom(int panes, const std::string& events = "") {
  std::string glass;
  for (int i = 0; i < panes; ++i)
    glass += fmt::format(R"(, {{"box": "white_stained_glass", "min": [1, 1, {0}], "max": [7, 5, {0}]}})", 3 - 2 * i);
  return fmt::format(R"({{"size": [9, 7, 9],
      "blocks": [{{"hollow": "white_concrete", "min": [0, 0, 0], "max": [8, 6, 8]}},
                 {{"block": "glowstone", "at": [4, 6, 6]}}{}],
      "cameras": [{{"name": "eye", "position": [4.5, 3.5, 6.5], "yaw": 180, "fov": 40}}],
      "environment": {{"time": 18000}}, "events": [{}]}})",
                     glass, events);
}

long long raysOf(int panes, const std::string& accumulation) {
  PackSession pack(glassRoom(panes),
                   {{"GI_METHOD", "BOUNCE_1"}, {"GI_COUNTERS", "true"}, {"TEMPORAL_ACCUMULATION", accumulation}},
                   kAcross, kAcross);
  pack.renderFrames(2);
  return readCounters(pack.session().renderer()).at("gi_state").at(1);
}

TEST(TranslucentRays, come_from_the_nearest_surface_of_a_pixel) {
  constexpr long long kPixels = kAcross * kAcross;
  EXPECT_EQ(raysOf(0, "true"), kPixels);
  EXPECT_EQ(raysOf(1, "true"), 2 * kPixels);
  EXPECT_EQ(raysOf(2, "true"), 2 * kPixels);
  // Without means nothing tells which is the nearest.
  EXPECT_EQ(raysOf(2, "false"), 3 * kPixels);
}

TEST(TranslucentRays, are_none_where_the_cache_has_the_light) {
  const auto rays = [](const std::string& light) {
    PackSession pack(glassRoom(1),
                     {{"GI_METHOD", "FACE_CACHE"}, {"GI_COUNTERS", "true"}, {"GI_LAMPS", "HIT"}, {"GI_TRANSLUCENT", light}},
                     kAcross, kAcross);
    pack.renderFrames(2);
    return readCounters(pack.session().renderer()).at("gi_state").at(1);
  };
  EXPECT_EQ(rays("AUTO"), rays("RAYS")) << "for the glass";
  EXPECT_GE(rays("RAYS") - rays("CACHED"), kAcross * kAcross);
}

/// Of the pixel in the middle: how many frames its mean is of.
float framesInMean(PackSession& pack, const char* buffer = "colortex12") {
  const ImageF means = pack.dump(buffer);
  const std::size_t middle = std::size_t(kAcross / 2 * kAcross + kAcross / 2);
  return means.pixels[middle * std::size_t(means.channels) + 3];
}

PackSession settling(const std::string& world) {
  return PackSession(world, {{"GI_METHOD", "FACE_CACHE"}, {"TEMPORAL_FRAMES", "64"}}, kAcross, kAcross);
}

TEST(TranslucentMean, gains_a_sample_each_frame) {
  PackSession pack = settling(glassRoom(1));
  pack.renderFrames(1);
  EXPECT_EQ(framesInMean(pack), kExpectedFrames + 1);
  pack.renderFrames(7);
  EXPECT_EQ(framesInMean(pack), kExpectedFrames + 8);
}

TEST(TranslucentMean, follows_its_place_as_the_eye_moves) {
  PackSession pack = settling(glassRoom(1));
  pack.look({4.5, 3.5, 6.5}, {4.5, 3.5, 4});
  pack.renderFrames(8);
  pack.look({4.7, 3.5, 6.5}, {4.7, 3.5, 4});  // the middle was outside of the picture
  pack.renderFrames(1);
  EXPECT_EQ(framesInMean(pack), kExpectedFrames + 1);
  pack.look({4.71, 3.5, 6.5}, {4.71, 3.5, 4});
  pack.renderFrames(1);
  EXPECT_EQ(framesInMean(pack), kExpectedFrames + 2);
}

TEST(TranslucentMean, begins_anew_where_nothing_translucent_was) {
  PackSession pack = settling(
      glassRoom(1, R"({"frame": 8, "set": {"at": [4, 3, 3], "block": "air"}},
                      {"frame": 12, "set": {"at": [4, 3, 3], "block": "white_stained_glass"}})"));
  pack.renderFrames(8);
  EXPECT_EQ(framesInMean(pack), kExpectedFrames + 8);
  pack.renderFrames(5);
  EXPECT_EQ(framesInMean(pack), kExpectedFrames + 1);
}

// A mean whose samples weigh TEMPORAL_WEIGHT each holds no more than what makes the next one weigh as much.
TEST(OpaqueMean, holds_fewer_frames_while_the_eye_moves) {
  PackSession pack = settling(glassRoom(0));
  for (int i = 0; i < 100; ++i) {
    pack.look({4.5 + .0005 * i, 3.5, 6.5}, {4.5 + .0005 * i, 3.5, 4});
    pack.renderFrames(1);
  }
  EXPECT_EQ(framesInMean(pack, "colortex3"), 28);
  pack.renderFrames(4);
  EXPECT_EQ(framesInMean(pack, "colortex3"), 32);
}

/// Of the green of a picture: its standard deviation over its mean, after few frames.
double noiseOfPicture(const std::string& filter) {
  PackSession pack(glassRoom(1), {{"GI_METHOD", "FACE_CACHE"}, {"GI_FILTER", filter}, {"DIRECT_LIGHT", "NONE"}},
                   kAcross, kAcross);
  pack.look({4.5, 3.5, 6.5}, {4.5, 3.3, 4});
  pack.renderFrames(8);
  const ImageF picture = pack.dump("colortex0");
  double sum = 0, squares = 0;
  for (std::size_t i = 1; i < picture.pixels.size(); i += std::size_t(picture.channels)) {
    sum += picture.pixels[i];
    squares += picture.pixels[i] * picture.pixels[i];
  }
  const double mean = sum / (kAcross * kAcross);
  return std::sqrt(std::max(0.0, squares / (kAcross * kAcross) - mean * mean)) / mean;
}

TEST(TranslucentMean, is_smoothed_within_a_face) {
  EXPECT_LT(noiseOfPicture("true"), .5 * noiseOfPicture("false"));
}

TEST(TranslucentMean, is_drawn_by_eighths_where_the_picture_rests) {
  PackSession pack(glassRoom(1), {{"GI_METHOD", "FACE_CACHE"}, {"TEMPORAL_FRAMES", "10"}}, kAcross, kAcross);
  pack.renderFrames(90);
  std::set<int> all;
  for (int frame = 0; frame < 8; ++frame) {
    const ImageF before = pack.dump("colortex12");
    pack.renderFrames(1);
    const ImageF after = pack.dump("colortex12");
    std::set<int> rows;
    for (std::size_t i = 0; i < before.pixels.size(); ++i)
      if (before.pixels[i] != after.pixels[i])
        rows.insert(int(i / std::size_t(before.channels)) / kAcross);
    EXPECT_EQ(rows.size(), kAcross / 8);
    all.insert(rows.begin(), rows.end());
  }
  EXPECT_EQ(all.size(), kAcross);
}

}  // namespace
}  // namespace orris::test
