// Clusters against all lights at points that a test chooses: the same bits.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "cluster_lab.h"
#include "lab.h"

namespace orris::test {
namespace {

/// Around the eye, of ranges 0.5 to 12.5.
const char* const kAround =
    "Light((random(i) - 0.5) * 40.0, 1.0 / pow(0.5 + 12.0 * random(i + 5000).x, 2.0), "
    "vec3(1.0) + random(i + 9000), 0.25)";
const char* const kSeen = "compare(seen(random(pixel.y * 4096 + pixel.x + 20000)))";

struct Comparison {
  int lit = 0;     ///< points that any light reaches
  int wrong = 0;   ///< not the same bits
  float most = 0;  ///< difference
};

void compareAll(ClusterLab& lab, int width, Comparison& sum) {
  for (int y = 0; y < width; ++y)
    for (int x = 0; x < width; ++x) {
      const auto [listed, all, same, unused] = lab.probe(x, y);
      sum.lit += all > 0;
      sum.wrong += same != 1;
      sum.most = std::max(sum.most, std::abs(listed - all));
    }
}

Comparison compareFrames(const ClusterSetup& setup, int frames) {
  ClusterLab lab(setup);
  Comparison sum;
  for (int frame = 0; frame < frames; ++frame) {
    lab.renderFrames(1);
    const ImageF image = lab.pack().dump("colortex0");
    for (size_t i = 0; i < image.pixels.size(); i += image.channels) {
      sum.lit += image.pixels[i + 1] > 0;
      sum.wrong += image.pixels[i + 2] != 1;
      sum.most = std::max(sum.most, std::abs(image.pixels[i] - image.pixels[i + 1]));
    }
  }
  return sum;
}

// Row F5 of docs/failure-modes.md.
TEST(ClusterLights, a_thousand_sets_of_lights_are_as_if_every_light_were_asked) {
  const OptionValues grids[] = {
      {},
      {{"LIGHT_METHOD", "TILED"}},
      {{"LIGHT_SLICING", "LINEAR"}},
      {{"LIGHT_FIRST_SLICE", "1.0"}, {"LIGHT_COLUMNS", "8"}, {"LIGHT_SLICES", "32"}},
  };
  for (const OptionValues& grid : grids) {
    const Comparison found = compareFrames(
        {.light = kAround, .lights = 60, .probe = kSeen, .options = grid, .width = 24}, 250);
    EXPECT_EQ(found.wrong, 0) << found.most;
    EXPECT_GT(found.lit, 250 * 24 * 24 / 4);
  }
}

TEST(ClusterLights, points_beside_the_screen_get_the_light_of_all) {
  const Comparison found = compareFrames(
      {.light = kAround,
       .lights = 60,
       .probe = "compare(seen(random(pixel.y * 4096 + pixel.x + 20000) * vec3(1.6, 1.6, 1.0) - "
                "vec3(0.3, 0.3, 0.0)))",
       .width = 24},
      20);
  EXPECT_EQ(found.wrong, 0) << found.most;
  EXPECT_GT(found.lit, 20 * 24 * 24 / 4);
}

TEST(ClusterLights, light_fades_to_nothing_at_its_range) {
  // A surface that faces the light at x/16 ranges from it.
  ClusterLab lab({.light = "Light(vec3(0.0), 1.0 / 64.0, vec3(1.0), 0.25)",
                  .lights = 1,
                  .probe = "vec4(light_irradiance_at(vec4(0.0, 0.0, 0.0, 1.0 / 64.0), vec4(1.0, "
                           "1.0, 1.0, 0.25), vec3(0.0, -float(pixel.x) / 2.0 + 1e-3, 0.0), "
                           "vec3(0.0, 1.0, 0.0), 0.0), 1.0)",
                  .width = 24});
  lab.renderFrames(1);
  EXPECT_NEAR(lab.probe(4, 0)[0], 1 / 4., .01) << "inverse square at 2";
  EXPECT_LT(lab.probe(16, 0)[0], 1e-6 / 64);
  EXPECT_EQ(lab.probe(17, 0)[0], 0);
}

// Row E1 of docs/failure-modes.md.
TEST(LampFalloff, light_is_finite_however_near_the_lamp) {
  // Rows: a small lamp's radius squared, a cube's.
  const double radius[] = {1. / 16, 1.5 / M_PI};
  const double distances[] = {0, 1e-4, .01, .3, .495, .6, 1};
  ClusterLab lab({.light = kAround,
                  .lights = 1,
                  .probe = "vec4(light_irradiance_at(vec4(1.0, 2.0, 3.0, 1.0 / 64.0), "
                           "vec4(vec3(100.0), pixel.y == 0 ? 0.0625 : 1.5 / pi), vec3(1.0, 2.0 - "
                           "float[7](0.0, 1e-4, 0.01, 0.3, 0.495, 0.6, 1.0)[min(pixel.x, 6)], "
                           "3.0), vec3(0.0, 1.0, 0.0), 0.0), 1.0)",
                  .width = 8});
  lab.renderFrames(1);
  for (int row = 0; row < 2; ++row)
    for (int i = 0; i < 7; ++i) {
      const float light = lab.probe(i, row)[0];
      const double most = 100 / std::max(distances[i] * distances[i], radius[row]);
      EXPECT_TRUE(std::isfinite(light)) << distances[i];
      EXPECT_LE(light, most * 1.0001) << distances[i];
      // Its own cell is the lamp.
      EXPECT_NEAR(light, distances[i] < .49 ? 0 : most, .01 * most) << distances[i];
    }
}

// Row F1 of docs/failure-modes.md.
TEST(ClusterSlices, slices_begin_where_the_formula_says) {
  const double first = 4, far = 64;
  const int slices = 24;
  // Column k: where slice k begins; rows: 8 units in the last place below to 8 above.
  ClusterLab lab({.light = kAround,
                  .lights = 1,
                  .probe = "vec4(slice_of(uintBitsToFloat(floatBitsToUint(slice_start(pixel.x)) + "
                           "uint(pixel.y - 8))), slice_start(pixel.x), 0.0, 1.0)",
                  .options = {{"LIGHT_FIRST_SLICE", "4.0"}, {"LIGHT_SLICES", "24"}},
                  .width = 32});
  lab.renderFrames(1);
  for (int k = 1; k < slices; ++k) {
    const double begins = first * std::pow(far / first, (k - 1.) / (slices - 1));
    EXPECT_NEAR(lab.probe(k, 8)[1] / begins, 1, 1e-4) << k;
    for (int ulp = -8; ulp <= 8; ++ulp)
      EXPECT_EQ(lab.probe(k, 8 + ulp)[0], ulp < 0 ? k - 1 : k) << k << ' ' << ulp;
  }
}

TEST(ClusterSlices, distances_beyond_both_ends_have_a_slice) {
  ClusterLab lab({.light = kAround,
                  .lights = 1,
                  .probe = "vec4(slice_of(float[8](-5.0, 0.0, 1e-30, 0.05, 63.999, 64.0, 1e9, "
                           "3e38)[min(pixel.x, 7)]))",
                  .width = 8});
  lab.renderFrames(1);
  for (int i = 0; i < 8; ++i) EXPECT_EQ(lab.probe(i, 0)[0], i < 4 ? 0 : 23) << i;
}

// Straight ahead, on either side of where slice k begins, and lights that end a hair beyond it, so few
// and small that the hair is not lost in other light.
TEST(ClusterSlices, points_where_slices_begin_get_the_light_of_all) {
  ClusterLab lab(
      {.light = "Light((gbufferModelViewInverse * vec4(0.0, 0.0, -slice_start(12 + i % 12) + (i < "
                "12 ? 1.0 : -1.0) * (0.8 - 1e-5 * random(i).x), 1.0)).xyz, 1.0 / 0.64, vec3(1.0), "
                "0.25)",
       .lights = 24,
       .probe = "compare(vec3(0.0, 0.0, -uintBitsToFloat(floatBitsToUint(slice_start(12 + pixel.x "
                "% 12)) + uint(pixel.y) - 8u)))",
       .width = 24});
  Comparison found;
  for (int frame = 0; frame < 24; ++frame) {
    lab.renderFrames(1);
    compareAll(lab, 17, found);
  }
  EXPECT_EQ(found.wrong, 0) << found.most;
  EXPECT_GT(found.lit, 1000);
}

// Row F4 of docs/failure-modes.md.
TEST(ClusterLights, lights_behind_the_eye_light_what_is_before_it) {
  const Comparison found = compareFrames(
      {.light = "Light((gbufferModelViewInverse * vec4((random(i).xy - 0.5) * 4.0, 0.5 + 6.0 * "
                "random(i).z, 1.0)).xyz, 1.0 / 64.0, vec3(1.0), 0.25)",
       .lights = 20,
       .probe = kSeen,
       .width = 32},
      20);
  EXPECT_EQ(found.wrong, 0) << found.most;
  EXPECT_GT(found.lit, 1000);
}

// Row F8 of docs/failure-modes.md.
TEST(ClusterLists, what_a_list_has_no_room_for_is_counted_and_kept_by_its_bit) {
  // A thousand lights too small to leave the cluster before the middle of a tile.
  ClusterLab lab({.light =
                      "Light((gbufferModelViewInverse * vec4(0.15, 0.15, -4.5, 1.0)).xyz, 1e4, "
                      "vec3(1.0), 0.25)",
                  .lights = 1000,
                  .probe = "vec4(0.0)",
                  .options = {{"LIGHT_LIST", "64"}}});
  lab.renderFrames(2);
  const LightState state = stateOf(lab.pack());
  EXPECT_EQ(state.lamps, 1000);
  EXPECT_EQ(state.spilled, 936);
  EXPECT_EQ(state.longest, 1000);
  EXPECT_EQ(state.entries, 1000);
  float longest = 0;
  int words = 0;
  const ImageF bits = lab.pack().dump("light_bits");
  for (int y = 0; y < bits.height; ++y) {
    longest = std::max(longest, bits.at(bits.width - 1, y)[0]);
    for (int word = 0; word + 1 < bits.width; ++word) words += bits.at(word, y)[0] != 0;
  }
  EXPECT_EQ(lampsOfLength(longest), 1000);
  EXPECT_EQ(words, 32 - 2) << "the list has those of two words";
  // Nothing but the one list, of which the first entry is light 0.
  int written = 0;
  for (const float entry : lab.pack().dump("light_list").pixels) written += entry != 0;
  EXPECT_EQ(written, 63);
}

TEST(ClusterLists, points_get_the_light_of_all_whether_lists_have_room_or_not) {
  const OptionValues coarse{{"LIGHT_LIST", "64"}, {"LIGHT_COLUMNS", "8"}, {"LIGHT_SLICES", "8"}};
  const OptionValues grids[] = {coarse, {{"LIGHT_LIST", "64"}, {"LIGHT_METHOD", "TILED"}}};
  for (const OptionValues& grid : grids) {
    ClusterLab lab(
        {.light = kAround, .lights = 1000, .probe = kSeen, .options = grid, .width = 24});
    lab.renderFrames(3);
    Comparison found;
    compareAll(lab, 24, found);
    EXPECT_EQ(found.wrong, 0) << found.most;
    EXPECT_GT(found.lit, 200);
    EXPECT_GT(stateOf(lab.pack()).spilled, 100);
  }
}

TEST(ClusterLists, what_lists_left_in_the_bits_is_gone_when_they_are_made_anew) {
  const auto entries = [](const char* room) {
    ClusterLab lab({.light = kAround,
                    .lights = 1000,
                    .probe = "vec4(0.0)",
                    .options = {{"LIGHT_LIST", room}, {"LIGHT_METHOD", "TILED"}},
                    .width = 8});
    lab.renderFrames(4);
    return stateOf(lab.pack()).entries;
  };
  EXPECT_EQ(entries("64"), entries("1024"));
}

TEST(ClusterLists, lists_are_sorted_and_hold_each_light_once) {
  ClusterLab lab({.light = kAround, .lights = 600, .probe = kSeen, .width = 8});
  lab.renderFrames(1);
  const ImageF list = lab.pack().dump("light_list");
  int entries = 0;
  for (int y = 0; y < list.height; ++y)
    for (int i = 1; i < list.width && list.at(i, y)[0] != 0; ++i, ++entries)
      ASSERT_GT(list.at(i, y)[0], list.at(i - 1, y)[0]) << y << ' ' << i;
  EXPECT_GT(entries, 1000);
  const ImageF bits = lab.pack().dump("light_bits");
  for (int y = 0; y < bits.height; ++y)
    for (int word = 0; word + 1 < bits.width; ++word) ASSERT_EQ(bits.at(word, y)[0], 0);
}

}  // namespace
}  // namespace orris::test
