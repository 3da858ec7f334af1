// Of a picture at rest an eighth is drawn; of one that changes all.
#include <gtest/gtest.h>

#include <array>
#include <set>

#include "pack_session.h"

namespace orris::test {
namespace {

constexpr int kSide = 32;
constexpr int kBands = 8;  // include/gi/rest.glsl

// Until means of ten frames are full: 48 frames after the first blocks, and ten.
constexpr int kRestsFrom = 60;

PackSession restingRoom(const std::string& events = "") {
  const std::string world = R"({
    "size": [9, 7, 9],
    "blocks": [{"hollow": "white_concrete", "min": [0, 0, 0], "max": [8, 6, 8]},
               {"block": "glowstone", "at": [4, 6, 4]}],
    "cameras": [{"name": "eye", "position": [4.5, 3.5, 6.5], "yaw": 180, "pitch": 10}],
    "environment": {"time": 18000},
    "events": [)" + events + "]}";
  return PackSession(world, {{"GI_METHOD", "FACE_CACHE"}, {"TEMPORAL_FRAMES", "10"}}, kSide, kSide);
}

/// Rows of a buffer that the next frame changes.
std::set<int> changedRows(PackSession& pack, const std::string& buffer) {
  const ImageF before = pack.dump(buffer);
  pack.renderFrames(1);
  const ImageF after = pack.dump(buffer);
  std::set<int> rows;
  const auto width = std::size_t(before.width) * std::size_t(before.channels);
  for (std::size_t i = 0; i < before.pixels.size(); ++i)
    if (before.pixels[i] != after.pixels[i]) rows.insert(int(i / width));
  return rows;
}

TEST(PictureAtRest, a_frame_draws_an_eighth_of_what_is_settled) {
  const std::array buffers = {"colortex3", "colortex6"};
  PackSession pack = restingRoom();
  pack.renderFrames(40);
  for (const char* buffer : buffers)
    EXPECT_EQ(changedRows(pack, buffer).size(), kSide) << buffer << " while the cache fills";
  pack.renderFrames(kRestsFrom - 42);
  for (const char* buffer : buffers) {
    std::set<int> all;
    for (int i = 0; i < kBands; ++i) {
      const std::set<int> rows = changedRows(pack, buffer);
      EXPECT_EQ(rows.size(), kSide / kBands) << buffer;
      EXPECT_EQ(*rows.rbegin() - *rows.begin(), kSide / kBands - 1) << "a band";
      all.insert(rows.begin(), rows.end());
    }
    EXPECT_EQ(all.size(), kSide) << "in turn";
  }
}

TEST(PictureAtRest, ends_with_the_frame_of_an_edit) {
  PackSession pack =
      restingRoom(R"({"frame": 100, "set": {"at": [1, 1, 7], "block": "glowstone"}})");
  pack.renderFrames(99);
  EXPECT_EQ(changedRows(pack, "colortex3").size(), kSide / kBands);
  EXPECT_EQ(changedRows(pack, "colortex3").size(), kSide);
  EXPECT_EQ(changedRows(pack, "colortex3").size(), kSide);
}

TEST(PictureAtRest, ends_as_the_eye_moves) {
  PackSession pack = restingRoom();
  pack.renderFrames(kRestsFrom);
  EXPECT_EQ(changedRows(pack, "colortex3").size(), kSide / kBands);
  pack.look({4.5, 3.5, 6}, {4, 2, 0});
  EXPECT_EQ(changedRows(pack, "colortex3").size(), kSide);
  pack.renderFrames(8);
  EXPECT_EQ(changedRows(pack, "colortex3").size(), kSide);
  EXPECT_EQ(changedRows(pack, "colortex3").size(), kSide / kBands);
}

}  // namespace
}  // namespace orris::test
