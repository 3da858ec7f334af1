// Rooms and what lamps light near them, against means of the path tracer.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "pack_session.h"
#include "reference_rooms.h"

namespace orris::test {
namespace {

// A tunnel longer than the volume, whose ends are shut; above it a floor that gets light under its roof from the sides.
TEST(ReferenceCave, cave_below_a_lit_floor_is_dark) {
  PackSession pack(R"({"size": [48, 12, 9],
      "blocks": [{"box": "stone", "min": [0, 0, 0], "max": [47, 6, 8]},
                 {"box": "air", "min": [1, 2, 3], "max": [46, 4, 5]},
                 {"box": "stone", "min": [0, 10, 1], "max": [47, 10, 7]}],
      "cameras": [{"name": "eye", "position": [24.5, 3.5, 4.5]}],
      "environment": {"time": 6000}})",
                   {{"GI_METHOD", "FACE_CACHE"},
                    {"VOXEL_SIZE", "32"},
                    {"AMBIENT_MINIMUM", "0.0"},
                    {"DIRECT_LIGHT", "NONE"}},
                   16, 9);
  pack.renderFrames(20);
  const glm::dvec3 seen = pack.meanRadiance();
  EXPECT_EQ(std::max({seen.r, seen.g, seen.b}), 0);
}

/// A room, and the mean of its picture of 16x9: orris trace --noise 0.002.
struct Room {
  const char* name;
  const char* wall;
  const char* lamp;  ///< block and place
  glm::dvec3 mean;
};
void PrintTo(const Room& room, std::ostream* out) { *out << room.name; }

class ReferenceRoom : public testing::TestWithParam<Room> {};

// White wool reflects .86: what is there after so many updates is what bright rooms need to come to rest, and the albedo of
// voxels to a thousandth. Lava in the floor lights the sides of its hole first, which light the room.
TEST_P(ReferenceRoom, is_as_bright_as_in_the_path_tracer) {
  const Room& room = GetParam();
  PackSession pack(fmt::format(R"({{"size": [11, 9, 11],
        "blocks": [{{"box": "{}", "min": [0, 0, 0], "max": [10, 8, 10]}},
                   {{"box": "air", "min": [2, 2, 2], "max": [8, 6, 8]}}, {{{}}}],
        "cameras": [{{"name": "eye", "position": [3, 3.5, 3], "target": [8, 4, 8], "fov": 70}}],
        "environment": {{"time": 18000}}}})",
                               room.wall, room.lamp),
                   manyRays(), 16, 9);
  pack.renderFrames(240);
  const glm::dvec3 ratio = glm::dvec3(pack.meanRadiance()) / room.mean;
  RecordProperty("ratio", fmt::format("{:.4f} {:.4f} {:.4f}", ratio.r, ratio.g, ratio.b));
  for (int channel = 0; channel < 3; ++channel) EXPECT_NEAR(ratio[channel], 1, .009) << channel;
}

INSTANTIATE_TEST_SUITE_P(, ReferenceRoom,
                         testing::Values(Room{"of_wool",
                                              "white_wool",
                                              R"("block": "glowstone", "at": [6, 7, 4])",
                                              {.40223, .31025, .16693}},
                                         Room{"with_lava_in_the_floor",
                                              "white_concrete",
                                              R"("block": "lava", "at": [6, 1, 4])",
                                              {.20989, .07228, .01255}}),
                         [](const auto& tested) { return std::string(tested.param.name); });

/// Mean red, whose colours are exact in voxels, of a room of white concrete.
double redOfWhiteRoom(const char* lamps) {
  PackSession pack(fmt::format(R"({{"size": [11, 9, 11],
        "blocks": [{{"box": "white_concrete", "min": [0, 0, 0], "max": [10, 8, 10]}},
                   {{"box": "air", "min": [2, 2, 2], "max": [8, 6, 8]}}, {{{}}}],
        "cameras": [{{"name": "eye", "position": [3, 3.5, 3], "target": [8, 4, 8], "fov": 70}}],
        "environment": {{"time": 18000}}}})",
                               lamps),
                   manyRays(), 16, 9);
  pack.renderFrames(120);
  return pack.meanRadiance().r;
}

// What is drawn of a small lamp stops light and covers floor, its ball does not. If the ball takes what meets it instead, the room
// is 2.4 % too bright. orris trace --seconds 25.
TEST(ReferenceSmallLamp, body_of_a_lantern_stops_light) {
  EXPECT_NEAR(redOfWhiteRoom(R"("block": "lantern", "at": [6, 2, 4])") / .76332, 1, .01);
}

// If its logs cover no floor, the room is 13 % too bright. They have no gaps in the pack. orris trace --seconds 15.
TEST(ReferenceSmallLamp, logs_of_a_campfire_cover_the_floor) {
  EXPECT_NEAR(redOfWhiteRoom(R"("block": "campfire", "at": [6, 2, 4])") / .84138, 1, .04);
}

// If their balls take what meets them, the room is 19 % too dark; if their rods are black, 5 %.
TEST(ReferenceSmallLamp, balls_of_many_torches_stop_none_and_their_rods_reflect) {
  EXPECT_NEAR(redOfWhiteRoom(R"("box": "torch", "min": [3, 2, 3], "max": [7, 2, 7])") / 13.894, 1, .03);
}

// A torch before panes of red glass, which tint what passes them outward. If they tint what the room gets of its ball, it is
// 10 % darker. orris trace --seconds 20.
TEST(ReferenceSmallLamp, glass_behind_a_torch_takes_none_of_its_light) {
  const char* lamp = R"("box": "red_stained_glass", "min": [9, 2, 5], "max": [10, 2, 7]}, {"block": "torch", "at": [8, 2, 6])";
  EXPECT_NEAR(redOfWhiteRoom(lamp) / .47884, 1, .02);
}

// The edge of a pool, below a lamp that it does not see, and its mirror image. With one value for what lies above the water and
// what lies below it, or half of what the top of the block gets, the picture is up to eleven times as bright. orris trace --seconds 8.
TEST(ReferenceShore, edge_above_the_water_has_its_own_light) {
  PackSession pack(R"({"size": [18, 10, 18],
      "blocks": [{"box": "stone", "min": [0, 0, 0], "max": [17, 9, 17]}, {"box": "air", "min": [2, 3, 2], "max": [15, 7, 15]},
                 {"box": "white_concrete", "min": [2, 2, 2], "max": [15, 2, 15]},
                 {"box": "water", "min": [6, 2, 6], "max": [11, 2, 11]}, {"block": "glowstone", "at": [13, 5, 8]}],
      "cameras": [{"name": "eye", "position": [7.5, 3.3, 8.5], "target": [11.9, 2.889, 8.5], "fov": 1.5}],
      "environment": {"time": 18000}})",
                   manyRays({{"WATER_WAVES", "false"}}), 16, 9);
  pack.renderFrames(160);
  expectTraced(pack.meanRadiance().g, .012967, .03);
}

// The underside of a roof over a field of snow at noon. If rays meet the layer lower than the sun does, it reflects no sunlight, a hundredth of
// the first bounce. orris trace --seconds 4: .29515 in green; of three layers .28359.
TEST(ReferenceSnow, layers_are_met_as_high_as_they_lie) {
  for (const auto& [layers, traced] : {std::pair{1, .29515}, {3, .28359}}) {
    PackSession pack(fmt::format(R"({{"size": [32, 12, 32],
        "blocks": [{{"box": "snow_block", "min": [0, 0, 0], "max": [31, 1, 31]}}, {{"box": "snow[layers={}]", "min": [0, 2, 0], "max": [31, 2, 31]}},
                   {{"box": "stone", "min": [12, 6, 12], "max": [18, 6, 18]}}],
        "cameras": [{{"name": "eye", "position": [15.5, 4, 15.5], "target": [15.6, 6, 15.5], "fov": 60}}],
        "environment": {{"time": 6000}}}})",
                                 layers),
                     kSettling, 16, 9);
    pack.renderFrames(60);
    expectTraced(pack.meanRadiance().g, traced, .03);
  }
}

// A room of stone below a roof of leaves at noon, and the leaves from below: what lights them has passed their sides, by holes or
// as through paper. If rays stop at them, the room is black. The shadow map has 1 texel for 4 of the leaves, so spots of sunlight
// are some percent off. orris trace --seconds 40, green.
TEST(ReferenceLeaves, roof_lights_the_room_below) {
  for (const auto& [camera, traced] :
       {std::pair{R"("position": [6, 4.4, 3.5], "target": [6.2, 2, 6.8])", .004284},
        {R"("position": [6.3, 2.4, 3.2], "target": [6.1, 5, 6.9])", .013866}}) {
    PackSession pack(fmt::format(R"({{"size": [12, 8, 12],
        "blocks": [{{"box": "stone", "min": [0, 0, 0], "max": [11, 5, 11]}}, {{"box": "air", "min": [2, 2, 2], "max": [9, 4, 9]}},
                   {{"box": "oak_leaves", "min": [2, 5, 2], "max": [9, 5, 9]}}],
        "cameras": [{{"name": "eye", {}, "fov": 60}}], "environment": {{"time": 6000}}}})",
                                 camera),
                     manyRays(), 16, 9);
    pack.renderFrames(80);
    expectTraced(pack.meanRadiance().g, traced, .09);
  }
}

// A room of stone whose floor is full of ferns, below a lamp: the ferns and the floor between them, and the walls. If rays pass
// plants, it is 11 and 6 % too bright, and what is between the ferns twice as bright. orris trace --seconds 15, green.
TEST(ReferencePlants, ferns_stop_light_and_give_it_back) {
  for (const auto& [camera, traced] : {std::pair{R"("position": [5.5, 6, 8], "target": [5.2, 2, 5], "fov": 60)", .011208},
                                       {R"("position": [2.4, 4.5, 2.3], "target": [8, 4.3, 8], "fov": 60)", .009385}}) {
    PackSession pack(stoneRoom(R"({"box": "fern", "min": [2, 2, 2], "max": [8, 2, 8]}, {"block": "glowstone", "at": [5, 7, 5]})",
                               camera),
                     manyRays(), 16, 9);
    pack.renderFrames(100);
    expectTraced(pack.meanRadiance().g, traced, .015);
  }
}

// Behind a wall, a room that is lit by what its gap lets through of one with a lamp: by faces on which light falls off. With one
// value a face it is 5 % too bright. orris trace --noise 0.004: .00003737 in green.
TEST(ReferenceCorner, light_falls_off_over_the_faces_of_a_gap) {
  const OptionValues options = manyRays();
  PackSession pack(R"({"size": [14, 9, 11],
      "blocks": [{"box": "stone", "min": [0, 0, 0], "max": [13, 8, 10]},
                 {"box": "air", "min": [2, 2, 2], "max": [11, 6, 8]},
                 {"box": "stone", "min": [6, 2, 2], "max": [6, 6, 5]}, {"block": "glowstone", "at": [8, 1, 3]}],
      "cameras": [{"name": "eye", "position": [4.5, 5.5, 4.5], "target": [6, 3, 3], "fov": 40}],
      "environment": {"time": 18000}})",
                   options, 16, 9);
  pack.renderFrames(160);
  expectTraced(pack.meanRadiance().g, .00003737, .03);
}

// At the dead end of a passage one block wide behind that gap: from block to block light falls to a third. On planes, which fall by as
// much everywhere, faces pass on too much of it, 19 % after three blocks; by a factor 6 to 8 %. orris trace --seconds 60: .0003791 in green.
TEST(ReferenceCorner, light_falls_by_a_factor_from_block_to_block) {
  PackSession pack(R"({"size": [8, 9, 9],
      "blocks": [{"box": "light_gray_concrete", "min": [0, 0, 0], "max": [7, 8, 8]},
                 {"box": "air", "min": [1, 1, 1], "max": [4, 6, 1]}, {"box": "air", "min": [1, 1, 3], "max": [4, 6, 5]},
                 {"box": "air", "min": [4, 1, 2], "max": [4, 6, 2]}, {"block": "sea_lantern", "at": [1, 1, 4]}],
      "cameras": [{"name": "eye", "position": [3.2, 3.6, 1.5], "target": [1, 3.6, 1], "fov": 50}],
      "environment": {"time": 18000}})",
                   manyRays(), 16, 9);
  pack.renderFrames(160);
  expectTraced(pack.meanRadiance().g, .0003791, .1);
}

// The floor before a pillar, beside the edge of the shadow that it throws in the light of an end rod: half of the floor's face is lit. Rays
// end on the pillar's foot and go on to that face. If they go on only once, the picture is 24 % too bright, else 4. orris trace --seconds 20:
// .005317 in green.
TEST(ReferenceCorner, rays_go_on_until_they_end_far_away) {
  PackSession pack(stoneRoom(R"({"box": "quartz_block", "min": [6, 2, 4], "max": [6, 6, 4]}, {"block": "end_rod", "at": [5, 2, 4]})",
                             R"("position": [6.75, 3.2, 7.0], "target": [6.7, 2, 5.04], "fov": 1.5)"),
                   manyRays(), 16, 9);
  pack.renderFrames(100);
  expectTraced(pack.meanRadiance().g, .005317, .1);
}

// Behind a wall, a floor that gets light by the sides of a small opening alone, whose outer edges have the more: with one value
// a side it is 22 % too bright. orris trace --noise 0.004: .00003224 in green.
TEST(ReferenceOpening, light_falls_off_over_its_sides) {
  PackSession pack(R"({"size": [14, 9, 11],
      "blocks": [{"box": "stone", "min": [0, 0, 0], "max": [13, 8, 10]},
                 {"box": "air", "min": [2, 2, 2], "max": [11, 6, 8]},
                 {"box": "stone", "min": [6, 2, 2], "max": [6, 6, 8]},
                 {"box": "air", "min": [6, 3, 6], "max": [6, 4, 6]}, {"block": "glowstone", "at": [9, 6, 2]}],
      "cameras": [{"name": "eye", "position": [4.5, 5.5, 3.5], "target": [3.5, 2, 3.01], "fov": 50}],
      "environment": {"time": 18000}})",
                   manyRays(), 16, 9);
  pack.renderFrames(400);
  expectTraced(pack.meanRadiance().g, .00003224, .035);
}

/// A hall from z = 2 to `mouth`, with a floor of its own as far as the volume reaches, or sand, and sand to `last`.
struct Hall {
  const char* floor;
  int mouth, last;
  double traced, tolerance;
};

// A hall whose open end looks at sunlit sand beyond the volume, which ends with z = 20: outside of the hall, with much sand beyond or
// little; where the hall ends, too, so that the ground at the edge gets little of the sky; and inside of it, where walls end one block
// later and are not known of. If rays find no ground there, its back is 19, 3, 29 and 27 % too dark, with the colour of the moss 23.
// orris trace --seconds 20, green.
TEST(ReferenceGround, beyond_the_volume_lights_a_hall) {
  for (const Hall& hall : {Hall{"sand", 16, 59, .010773, .01},
                           {"sand", 16, 21, .008945, .01},
                           {"sand", 20, 59, .0065918, .03},
                           {"sand", 21, 59, .0059057, .045},
                           {"moss_block", 16, 59, .0079685, .01}}) {
    PackSession pack(fmt::format(R"({{"size": [12, 8, {}],
        "blocks": [{{"box": "sand", "min": [0, 0, 0], "max": [11, 0, {}]}}, {{"box": "{}", "min": [0, 0, 0], "max": [11, 0, 20]}},
                   {{"box": "stone", "min": [1, 1, 1], "max": [10, 6, {}]}}, {{"box": "air", "min": [2, 1, 2], "max": [9, 5, {}]}}],
        "cameras": [{{"name": "eye", "position": [5.5, 3, 5.5], "target": [5.2, 3.4, 2], "fov": 70}}],
        "environment": {{"time": 3000}}}})",
                                 hall.last + 1, hall.last, hall.floor, hall.mouth, hall.mouth),
                     manyRays({{"VOXEL_SIZE", "32"}}), 16, 9);
    pack.renderFrames(100);
    SCOPED_TRACE(fmt::format("{} {} {}", hall.floor, hall.mouth, hall.last));
    expectTraced(pack.meanRadiance().g, hall.traced, hall.tolerance);
  }
}

/// What a lamp lights near it: the mean of a picture of 16x9 as orris trace finds it.
struct Spot {
  const char* name;
  const char* blocks;
  const char* camera;
  double green;
  double error;  ///< relative
};
void PrintTo(const Spot& spot, std::ostream* out) { *out << spot.name; }

class ReferenceSpot : public testing::TestWithParam<Spot> {};

TEST_P(ReferenceSpot, is_as_bright_as_in_the_path_tracer) {
  const Spot& spot = GetParam();
  PackSession pack(stoneRoom(spot.blocks, spot.camera), manyRays(), 16, 9);
  pack.renderFrames(60);
  EXPECT_NEAR(pack.meanRadiance().g / spot.green, 1, spot.error);
}

// The edge of its shadow crosses the side of a block of glass.
constexpr const char* kPillarBeforeGlass =
    R"({"box": "white_stained_glass", "min": [2, 2, 4], "max": [8, 6, 4]},
       {"box": "stone", "min": [6, 2, 6], "max": [6, 6, 6]}, {"block": "end_rod", "at": [7, 4, 8]})";

// Its planes lie 6/16 behind the front of its frame, which shades the floor and parts light on its own inside.
constexpr const char* kPortal =
    R"({"box": "white_concrete", "min": [4, 2, 4], "max": [7, 6, 4]}, {"box": "nether_portal[axis=x]", "min": [5, 3, 4], "max": [6, 5, 4]})";

constexpr const char* kFire = R"({"block": "fire", "at": [5, 2, 4]})";
constexpr const char* kSoulFire = R"({"block": "soul_fire", "at": [5, 2, 4]})";

INSTANTIATE_TEST_SUITE_P(
    , ReferenceSpot,
    testing::Values(
        Spot{"floor_below_a_torch", R"({"block": "torch", "at": [5, 2, 4]})",
             R"("position": [8, 5, 7], "target": [8, 2, 6.3], "fov": 20)", .01355, .025},
        Spot{"wall_beside_lava", R"({"box": "lava", "min": [3, 1, 3], "max": [6, 1, 6]})",
             R"("position": [6, 4, 8.5], "target": [2, 3.5, 5], "fov": 30)", .1308, .03},
        Spot{"side_of_leaves_below_a_lamp",
             R"({"block": "oak_leaves", "at": [5, 2, 4]}, {"block": "glowstone", "at": [5, 7, 4]})",
             R"("position": [5.5, 2.6, 7.5], "target": [5.5, 2.5, 5], "fov": 16)", .00702, .1},
        Spot{"inside_of_leaves_by_a_hole",
             R"({"block": "oak_leaves", "at": [5, 3, 4]}, {"block": "glowstone", "at": [5, 7, 4]})",
             R"("position": [5.5, 3.6, 7.5], "target": [5.17, 3.74, 5], "fov": 1.5)", .006806, .06},
        Spot{
            "behind_stained_panes",
            R"({"box": "red_stained_glass_pane[east=true,west=true]", "min": [2, 2, 4], "max": [8, 6, 4]},
                            {"block": "glowstone", "at": [5, 7, 3]})",
            R"("position": [5.5, 4, 5.5], "target": [5.5, 2, 7], "fov": 60)", .0002045, .06},
        Spot{
            "between_the_sides_of_a_stained_pane",
            R"({"box": "red_stained_glass_pane[east=true,west=true]", "min": [2, 2, 4], "max": [8, 6, 4]},
                            {"block": "glowstone", "at": [5, 7, 3]})",
            R"("position": [5.5, 4, 5.5], "target": [5.5, 2, 4.53], "fov": 1)", .007698, .03},
        Spot{"behind_panes",
             R"({"box": "glass_pane[east=true,west=true]", "min": [2, 2, 4], "max": [8, 6, 4]},
                            {"block": "glowstone", "at": [5, 7, 3]})",
             R"("position": [5.5, 4, 5.5], "target": [5.5, 2, 7], "fov": 60)", .007447, .04},
        Spot{"behind_panes_before_a_lamp",
             R"({"box": "glass_pane[east=true,west=true]", "min": [2, 2, 4], "max": [8, 6, 4]},
                            {"block": "glowstone", "at": [5, 4, 1]})",
             R"("position": [5.5, 4, 5.5], "target": [5.5, 3.5, 8], "fov": 60)", .008315, .04},
        Spot{"ceiling_above_fire", kFire, R"("position": [5.5, 3, 7.5], "target": [5.5, 7, 4.5], "fov": 30)", .03307, .045},
        Spot{"floor_beside_soul_fire", kSoulFire, R"("position": [8, 5, 7], "target": [7, 2, 5.5], "fov": 20)", .04563, .03},
        Spot{"floor_within_soul_fire", kSoulFire,
             R"("position": [5.25, 5.5, 4.5], "target": [5.25, 2, 4.26], "fov": 4)", 1.657, .12},
        Spot{"floor_before_a_portal", kPortal, R"("position": [6, 5, 8.5], "target": [6, 2, 5.6], "fov": 20)", .03532, .02},
        Spot{"frame_of_a_portal", kPortal, R"("position": [6.5, 4.5, 6.5], "target": [5, 4.5, 4.74], "fov": 1.5)", .9871, .015},
        Spot{"glass_beside_the_shadow_of_a_pillar", kPillarBeforeGlass,
             R"("position": [8.3, 4.5, 6.5], "target": [6.93, 4.5, 5], "fov": 2)", .2319, .04},
        Spot{"glass_in_the_shadow_of_a_pillar", kPillarBeforeGlass,
             R"("position": [8.3, 4.5, 6.5], "target": [6.5, 4.5, 5], "fov": 2)", .01783, .06}),
    [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace orris::test
