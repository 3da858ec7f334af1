// Rooms whose light is held against the path tracer, and the options with which it comes to rest soon.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

#include "pack_session.h"

namespace orris::test {

/// A closed room of stone by night, seven blocks wide and five high from (2, 2, 2) on, with `blocks` in it.
inline std::string stoneRoom(const char* blocks, const char* camera) {
  return fmt::format(R"({{"size": [11, 9, 11],
      "blocks": [{{"box": "stone", "min": [0, 0, 0], "max": [10, 8, 10]}},
                 {{"box": "air", "min": [2, 2, 2], "max": [8, 6, 8]}}, {}],
      "cameras": [{{"name": "eye", {}}}], "environment": {{"time": 18000}}}})",
                     blocks, camera);
}

inline const OptionValues kSettling = {
    {"GI_METHOD", "FACE_CACHE"}, {"GI_LAMPS", "SAMPLED"},     {"GI_SAMPLES", "4"},
    {"GI_FILTER", "false"},      {"TEMPORAL_FRAMES", "1024"}, {"AMBIENT_MINIMUM", "0.0"},
    {"DIRECT_LIGHT", "NONE"},    {"FACE_SHARE", "1"},         {"FACE_WINDOW", "256"}};

/// The same with less noise: 16 rays a pixel and 8 a face.
inline OptionValues manyRays(OptionValues changes = {}) {
  changes.insert({{"GI_SAMPLES", "16"}, {"FACE_RAYS", "8"}});
  changes.insert(kSettling.begin(), kSettling.end());
  return changes;
}

/// A picture's mean is that of `orris trace`, to a share of `tolerance`.
inline void expectTraced(double seen, double traced, double tolerance) {
  testing::Test::RecordProperty("ratio", fmt::format("{:.4f}", seen / traced));
  EXPECT_NEAR(seen / traced, 1, tolerance);
}

}  // namespace orris::test
