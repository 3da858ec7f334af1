// Lamps of worlds: collected, sorted, kept while nothing changes, the same picture with every method.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "cluster_lab.h"

namespace orris::test {
namespace {

/// A floor under the night sky, seen from above its middle.
std::string floorWith(const std::string& blocks, const std::string& events = "") {
  return fmt::format(R"({{
    "size": [32, 12, 32],
    "blocks": [{{"box": "white_concrete", "min": [0, 0, 0], "max": [31, 0, 31]}}{}],
    "cameras": [{{"name": "eye", "position": [16.5, 5.5, 24.5], "yaw": 180, "pitch": 25}}],
    "environment": {{"time": 18000}}, "events": [{}]}})",
                     blocks.empty() ? "" : ", " + blocks, events);
}

const char* const kThreeLamps = R"(
    {"block": "torch", "at": [[12, 1, 14], [20, 1, 16]]},
    {"block": "sea_lantern", "at": [16, 1, 12]},
    {"box": "red_stained_glass", "min": [10, 1, 18], "max": [22, 2, 18]},
    {"box": "water", "min": [6, 1, 8], "max": [9, 1, 20]})";

PackSession sessionOf(const std::string& world, const std::string& method,
                      OptionValues options = {}, int width = 48) {
  options.emplace("LIGHT_METHOD", method);
  options.emplace("GI_METHOD", "NONE");
  options.emplace("SHADOW_METHOD", "NONE");
  return PackSession({.world = world, .options = options, .width = width, .height = width});
}

ImageF pictureOf(const std::string& world, const std::string& method, int frames = 1) {
  PackSession pack = sessionOf(world, method);
  pack.renderFrames(frames);
  return pack.dump("colortex0");
}

TEST(ClusteredLamps, every_method_gives_the_same_picture) {
  const std::string world = floorWith(kThreeLamps);
  const ImageF deferred = pictureOf(world, "DEFERRED");
  EXPECT_EQ(pictureOf(world, "TILED").pixels, deferred.pixels);
  EXPECT_EQ(pictureOf(world, "CLUSTERED").pixels, deferred.pixels);
  // Lit where they are drawn, so at the vertices' positions, not those that the depth gives.
  const ImageF forward = pictureOf(world, "FORWARD");
  for (size_t i = 0; i < forward.pixels.size(); ++i) {
    const float light = deferred.pixels[i];
    ASSERT_NEAR(forward.pixels[i], light, (1 + light) / 255) << i;
  }
}

/// What a spot of floor at (16.5, z) under a roof reflects of one lamp to an eye at z = 24.5, over the same
/// as by a diffuse surface.
double glossAt(double z, const char* reflection) {
  const auto light = [&](const char* gloss) {
    PackSession pack = sessionOf(floorWith(R"({"block": "sea_lantern", "at": [16, 4, 12]},
                                   {"box": "stone", "min": [0, 11, 0], "max": [31, 11, 31]})"),
                                 "CLUSTERED",
                                 {{"AMBIENT_MINIMUM", "0.0"},
                                  {"SKY_STRENGTH", "0.0"},
                                  {"DIRECT_LIGHT", reflection},
                                  {"LIGHT_GLOSS", gloss}},
                                 16);
    pack.look({16.5, 5.5, 24.5}, {16.5, 1, z});
    pack.renderFrames(1);
    return pack.meanRadiance().g;
  };
  return light("true") / light("false");
}

TEST(ClusteredLamps, highlights_are_where_a_mirror_would_show_the_lamp) {
  for (const char* reflection : {"PHONG", "LAMBERT_GGX"})
    EXPECT_GT(glossAt(17.75, reflection), 1.1) << reflection;
  EXPECT_NEAR(glossAt(10, "PHONG"), 0.9, 0.01) << "what Phong's diffuse part has";
}

TEST(ClusteredLamps, every_method_gives_the_same_highlights) {
  const auto picture = [](const char* method) {
    PackSession pack = sessionOf(floorWith(kThreeLamps), method, {{"LIGHT_GLOSS", "true"}});
    pack.renderFrames(1);
    return pack.dump("colortex0");
  };
  const ImageF deferred = picture("DEFERRED"), forward = picture("FORWARD");
  EXPECT_EQ(picture("CLUSTERED").pixels, deferred.pixels);
  EXPECT_NE(pictureOf(floorWith(kThreeLamps), "DEFERRED").pixels, deferred.pixels);
  for (size_t i = 0; i < forward.pixels.size(); ++i)
    ASSERT_NEAR(forward.pixels[i], deferred.pixels[i], (1 + deferred.pixels[i]) / 255) << i;
}

// Row F3 of docs/failure-modes.md.
// The slice is that of the distance, not of the depth buffer's number.
TEST(ClusterSlices, slices_on_a_floor_are_where_the_plane_is) {
  PackSession pack = sessionOf(
      floorWith(R"({"block": "torch", "at": [2, 1, 2]})"), "CLUSTERED",
      {{"LIGHT_DEBUG", "COUNT"}, {"LIGHT_FIRST_SLICE", "4.0"}, {"LIGHT_SLICES", "24"}}, 96);
  pack.renderFrames(1);
  const ImageF image = pack.dump("colortex0");
  const double pitch = 25 * M_PI / 180, half = std::tan(35 * M_PI / 180);
  std::set<int> seen;
  for (int row = 0; row < 96; ++row) {
    const double slope = (1 - (row + .5) / 48) * half;  // upward, over distance along the axis
    const double distance = 4.5 / (std::sin(pitch) - slope * std::cos(pitch));
    const double place = 1 + 23 * std::log(distance / 4) / std::log(64. / 4);
    if (distance < 0 || distance > 22 || std::abs(place - std::round(place)) < .01) continue;
    const int slice = std::max(0, static_cast<int>(std::floor(place)));
    EXPECT_EQ(std::lround(image.at(48, row)[1] * 1000), slice) << row << ' ' << distance;
    seen.insert(slice);
  }
  EXPECT_GT(seen.size(), 8U);
}

TEST(ClusteredLamps, views_of_the_grid_show_what_is_counted) {
  const std::string world =
      floorWith(R"({"box": "sea_lantern", "min": [10, 1, 6], "max": [20, 1, 16]})");
  const auto view = [&world](const char* what) {
    PackSession pack = sessionOf(
        world, "CLUSTERED", {{"LIGHT_DEBUG", what}, {"LIGHT_LIST", "64"}, {"LIGHT_RANGE", "0.5"}});
    pack.renderFrames(1);
    return pack.dump("colortex0");
  };
  const ImageF count = view("COUNT"), slice = view("SLICE"), heat = view("HEAT");
  int full = 0, none = 0;
  for (int y = 0; y < count.height; ++y)
    for (int x = 0; x < count.width; ++x) {
      const float *counted = count.at(x, y), *heated = heat.at(x, y);
      if (counted[0] + counted[1] + counted[2] == 0) continue;  // sky
      EXPECT_NEAR(slice.at(x, y)[0], float(std::lround(counted[1] * 1000) & 7) / 7, 1e-3);
      const long lamps = std::lround(counted[0] * 1000);
      full += lamps > 64;
      none += lamps <= 1;
      EXPECT_EQ(heated[0] == 1 && heated[1] == 1 && heated[2] == 1, lamps > 64) << lamps;
      EXPECT_EQ(heated[2] == 1 && heated[1] == 0, lamps <= 1) << lamps;
    }
  EXPECT_GT(full, 20);
  EXPECT_GT(none, 5);
}

TEST(ClusteredLamps, translucent_surfaces_are_lit_by_the_same_lists) {
  // Nothing but glass is in sight.
  const auto picture = [](const std::string& lamp, const std::string& method) {
    return pictureOf(floorWith(R"({"box": "white_stained_glass", "min": [0, 1, 20],
                                   "max": [31, 11, 20]})" +
                               lamp),
                     method);
  };
  const char* const lamp = R"(, {"block": "sea_lantern", "at": [16, 6, 23]})";
  const ImageF lit = picture(lamp, "CLUSTERED");
  EXPECT_EQ(lit.pixels, picture(lamp, "DEFERRED").pixels);
  const float* above = lit.at(24, 6);
  EXPECT_GT(above[0], 10 * picture("", "CLUSTERED").at(24, 6)[0]);
}

TEST(ClusteredLamps, table_is_sorted_by_place) {
  std::string lamps;
  for (int i = 0; i < 60; ++i)
    lamps += fmt::format(R"({}{{"block": "torch", "at": [{}, 1, {}]}})", i ? "," : "", i * 7 % 31,
                         i * 5 % 29);
  PackSession pack = sessionOf(floorWith(lamps), "DEFERRED");
  pack.renderFrames(1);
  const LightState state = stateOf(pack);
  const ImageF table = pack.dump("light_table");
  ASSERT_GT(state.lamps, 40);
  double before = -1;
  for (int i = 0; i < state.lamps; ++i) {
    const float* place = table.at(2 * i, table.height - 1);
    const double key = (place[2] * 128 + place[1]) * 128. + place[0];
    EXPECT_GT(key, before) << i;
    before = key;
  }
}

TEST(ClusteredLamps, few_lamps_get_no_lists_when_the_method_is_chosen_by_its_cost) {
  const auto square = [](int side) {
    return floorWith(fmt::format(
        R"({{"box": "magma_block", "min": [3, 1, 3], "max": [{0}, 1, {0}]}})", 2 + side));
  };
  for (const int side : {2, 25}) {
    PackSession chosen = sessionOf(square(side), "AUTO", {}, 96);
    chosen.renderFrames(1);
    EXPECT_EQ(stateOf(chosen).lamps, side * side);
    EXPECT_EQ(stateOf(chosen).grids, side > 2) << side;
    PackSession deferred = sessionOf(square(side), "DEFERRED", {}, 96);
    deferred.renderFrames(1);
    EXPECT_EQ(chosen.dump("colortex0").pixels, deferred.dump("colortex0").pixels) << side;
  }
}

// Without the lines of shaders.properties that a host chooses by, as in the game.
TEST(ClusteredLamps, few_lamps_get_no_lists_when_the_pack_chooses_for_itself) {
  const auto row = [](int count) {
    return floorWith(
        fmt::format(R"({{"box": "torch", "min": [6, 1, 12], "max": [{}, 1, 12]}})", 5 + count));
  };
  for (const int count : {8, 9}) {
    SessionSetup setup{
        .world = row(count),
        .options = {{"LIGHT_METHOD", "AUTO"}, {"GI_METHOD", "NONE"}, {"SHADOW_METHOD", "NONE"}},
        .width = 48,
        .height = 48};
    setup.change = [](PackTexts& files) {
      std::string& text = files.at("/shaders.properties");
      for (std::size_t at = 0; (at = text.find("\nauto.", at)) != std::string::npos; ++at)
        text.insert(at + 1, "#");
    };
    PackSession chosen(setup);
    chosen.renderFrames(1);
    EXPECT_EQ(stateOf(chosen).lamps, count);
    EXPECT_EQ(stateOf(chosen).grids, count > 8);
    EXPECT_EQ(chosen.dump("colortex0").pixels, pictureOf(row(count), "DEFERRED").pixels) << count;
  }
}

TEST(ClusteredLamps, two_runs_give_the_same_bits) {
  const std::string world = floorWith(kThreeLamps);
  PackSession first = sessionOf(world, "CLUSTERED"), second = sessionOf(world, "CLUSTERED");
  first.renderFrames(2);
  second.renderFrames(2);
  for (const char* buffer : {"colortex0", "light_table", "light_list", "light_bits"})
    EXPECT_EQ(first.dump(buffer).pixels, second.dump(buffer).pixels) << buffer;
}

TEST(ClusteredLamps, nothing_is_made_anew_while_nothing_changes) {
  PackSession pack =
      sessionOf(floorWith(kThreeLamps,
                          R"({"frame": 6, "set": {"at": [20, 1, 16], "block": "air"}},
                   {"frame": 6, "set": {"at": [20, 1, 17], "block": "torch"}})"),
                "CLUSTERED");
  pack.renderFrames(1);
  const LightState first = stateOf(pack);
  pack.renderFrames(4);
  const LightState still = stateOf(pack);
  EXPECT_EQ(still.tables, first.tables);
  EXPECT_EQ(still.grids, first.grids);
  pack.renderFrames(4);  // a lamp moves in frame 6
  const LightState moved = stateOf(pack);
  EXPECT_EQ(moved.tables, first.tables + 1);
  EXPECT_EQ(moved.grids, first.grids + 1);
  EXPECT_EQ(moved.lamps, 3);
  pack.look({16.6, 5.5, 24.5}, {16.6, 3, 14});  // in the same block
  pack.renderFrames(3);
  const LightState looked = stateOf(pack);
  EXPECT_EQ(looked.tables, moved.tables);
  EXPECT_GT(looked.grids, moved.grids);
  pack.renderFrames(2);
  EXPECT_EQ(stateOf(pack).grids, looked.grids);
  pack.look({18.6, 5.5, 24.5}, {16.6, 3, 14});
  pack.renderFrames(1);
  EXPECT_EQ(stateOf(pack).tables, looked.tables + 1);
}

TEST(ClusteredLamps, a_lamp_that_moved_lights_as_if_it_had_always_been_there) {
  const auto torchAt = [](int z) {
    return fmt::format(R"({{"block": "torch", "at": [20, 1, {}]}})", z);
  };
  const std::string events = R"({"frame": 3, "set": {"at": [20, 1, 16], "block": "air"}},
                                {"frame": 3, "set": {"at": [20, 1, 18], "block": "torch"}})";
  const ImageF moved = pictureOf(floorWith(torchAt(16), events), "CLUSTERED", 5);
  EXPECT_EQ(moved.pixels, pictureOf(floorWith(torchAt(18)), "CLUSTERED", 5).pixels);
  EXPECT_NE(moved.pixels, pictureOf(floorWith(torchAt(16)), "CLUSTERED", 5).pixels);
}

TEST(ClusteredLamps, table_without_room_counts_what_is_missing) {
  PackSession pack =
      sessionOf(floorWith(R"({"box": "sea_lantern", "min": [4, 2, 4], "max": [18, 2, 23]})"),
                "CLUSTERED", {{"LIGHT_CAPACITY", "256"}});
  pack.renderFrames(1);
  EXPECT_EQ(stateOf(pack).lamps, 256);
  EXPECT_EQ(stateOf(pack).lampsDropped, 15 * 20 - 256);
}

TEST(ClusteredLamps, spots_shine_one_way) {
  // Mean over the floor below a rod that hangs in the air.
  const auto below = [](const char* state) {
    PackSession pack = sessionOf(
        floorWith(fmt::format(R"({{"block": "{}", "at": [16, 4, 16]}})", state)), "DEFERRED",
        {{"AMBIENT_MINIMUM", "0.0"}, {"SKY_STRENGTH", "0.0"}, {"DIRECT_LIGHT", "NONE"}});
    pack.look({16.5, 3.9, 16.6}, {16.5, 0, 16.5});
    pack.renderFrames(1);
    return pack.meanRadiance().g;
  };
  const double down = below("end_rod[facing=down]");
  EXPECT_GT(down, 0.1);
  EXPECT_LT(below("end_rod[facing=up]"), 1e-3 * down);
  EXPECT_LT(below("end_rod[facing=east]"), 1e-3 * down);
}

TEST(ClusteredLamps, spots_are_in_the_lists_of_all_that_they_light) {
  const std::string world = floorWith(
      R"({"block": "end_rod[facing=down]", "at": [[16, 5, 14], [9, 8, 18]]},
         {"block": "end_rod[facing=east]", "at": [[22, 2, 12], [5, 1, 8]]},
         {"block": "end_rod[facing=north]", "at": [[12, 1, 21]]})");
  const ImageF deferred = pictureOf(world, "DEFERRED");
  EXPECT_EQ(pictureOf(world, "TILED").pixels, deferred.pixels);
  EXPECT_EQ(pictureOf(world, "CLUSTERED").pixels, deferred.pixels);
  EXPECT_NE(pictureOf(floorWith(""), "DEFERRED").pixels, deferred.pixels);
}

/// Mean light of a spot of floor at (16.5, z), by lamps alone.
glm::dvec3 lightOfFloor(const std::string& blocks, double z, const char* shadows) {
  PackSession pack = sessionOf(floorWith(blocks), "CLUSTERED",
                               {{"AMBIENT_MINIMUM", "0.0"},
                                {"SKY_STRENGTH", "0.0"},
                                {"DIRECT_LIGHT", "NONE"},
                                {"VOXEL_SIZE", "32"},
                                {"LIGHT_SHADOWS", shadows}},
                               16);
  pack.look({16.5, 6, z + 0.1}, {16.5, 1, z});
  pack.renderFrames(1);
  return pack.meanRadiance();
}

constexpr const char* kWall = R"(, {"box": "stone", "min": [8, 1, 13], "max": [24, 4, 13]})";

TEST(ClusteredLamps, rays_find_what_hides_a_lamp) {
  for (const char* lamp : {"sea_lantern", "torch"}) {
    const std::string blocks = fmt::format(R"({{"block": "{}", "at": [16, 1, 10]}})", lamp) + kWall;
    const double open = lightOfFloor(blocks, 15.5, "0").g;
    EXPECT_GT(open, 1e-3) << lamp;
    EXPECT_LT(lightOfFloor(blocks, 15.5, "1").g, 1e-4 * open) << lamp;
    EXPECT_NEAR(lightOfFloor(blocks, 12.3, "1").g / lightOfFloor(blocks, 12.3, "0").g, 1, 1e-3)
        << lamp << " is seen from before the wall";
  }
}

TEST(ClusteredLamps, rays_to_lamps_pass_glass_with_its_colour) {
  const std::string blocks = R"({"block": "sea_lantern", "at": [16, 1, 10]},
                                {"box": "red_stained_glass", "min": [8, 1, 13], "max": [24, 4, 13]})";
  const glm::dvec3 open = lightOfFloor(blocks, 15.5, "0"), tinted = lightOfFloor(blocks, 15.5, "1");
  EXPECT_GT(tinted.r, 0.1 * open.r);
  EXPECT_LT(tinted.r, open.r);
  EXPECT_LT(tinted.b / open.b, 0.5 * tinted.r / open.r);
}

TEST(ClusteredLamps, as_many_lamps_have_shadows_as_are_asked_for) {
  const std::string strong = R"({"block": "sea_lantern", "at": [16, 1, 11]})";
  const std::string weak = R"({"block": "redstone_torch[lit=true]", "at": [17, 1, 11]})";
  const double left = lightOfFloor(strong + "," + weak + kWall, 15.5, "1").r;
  EXPECT_GT(left, 0);
  EXPECT_NEAR(left / lightOfFloor(weak + kWall, 15.5, "0").r, 1, 0.01) << "the strongest is gone";
  EXPECT_LT(lightOfFloor(strong + "," + weak + kWall, 15.5, "2").r, 1e-4);
}

TEST(ClusteredLamps, light_is_not_counted_twice_with_global_illumination) {
  const std::string world = floorWith(R"({"block": "sea_lantern", "at": [16, 3, 16]})");
  const auto below = [&world](const char* light) {
    PackSession pack({.world = world,
                      .options = {{"LIGHT_METHOD", light},
                                  {"GI_METHOD", "BOUNCE_1"},
                                  {"GI_FILTER", "false"},
                                  {"GI_SAMPLES", "16"},
                                  {"TEMPORAL_FRAMES", "256"},
                                  {"AMBIENT_MINIMUM", "0.0"},
                                  {"VOXEL_SIZE", "32"}},
                      .width = 16,
                      .height = 16});
    pack.look({16.5, 4.5, 22.5}, {16.5, 1, 18.5});
    pack.renderFrames(4);
    return pack.meanRadiance().g;
  };
  // The lamp's cube by rays against a point of its mean area: not the same, and not twice.
  EXPECT_NEAR(below("CLUSTERED") / below("NONE"), 1, 0.25);
}

TEST(ClusteredLamps, lightmap_does_not_light_where_lamps_do) {
  const std::string world = floorWith(R"({"block": "sea_lantern", "at": [16, 1, 16]})");
  const auto behind = [&world](const char* method) {
    PackSession pack =
        sessionOf(world, method, {{"AMBIENT_MINIMUM", "0.0"}, {"LIGHT_RANGE", "0.25"}});
    pack.look({16.5, 4.5, 22.5}, {16.5, 1, 22.4});  // beyond the range of 3.75
    pack.renderFrames(1);
    return pack.meanRadiance().r;
  };
  EXPECT_LT(behind("CLUSTERED"), 0.2 * behind("NONE"));
}

}  // namespace
}  // namespace orris::test
