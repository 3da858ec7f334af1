#include <orris/world/blocks/shape_boxes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>
#include <string>

#include <orris/world/blocks/block_facts.h>
#include <orris/world/blocks/block_state.h>

namespace orris {
namespace {

/// "x0 y0 z0 x1 y1 z1" of each box, sorted.
std::vector<std::string> boxes(const std::string& state) {
  static const BlockTable table;
  const auto parsed = parseBlockState(state);
  EXPECT_TRUE(parsed) << state;
  const BlockFacts facts = table.factsOf(*parsed);
  EXPECT_TRUE(facts.known) << state;
  std::vector<std::string> result;
  for (const ShapeBox& box : facts.boxes) {
    char text[96];
    std::snprintf(text, sizeof text, "%g %g %g %g %g %g", box.from.x, box.from.y, box.from.z,
                  box.to.x, box.to.y, box.to.z);
    result.push_back(text);
  }
  std::sort(result.begin(), result.end());
  return result;
}

using Boxes = std::vector<std::string>;

struct ShapeCase {
  const char* state;
  Boxes expected;
};

void PrintTo(const ShapeCase& shape, std::ostream* out) { *out << shape.state; }

class BlockShapes : public testing::TestWithParam<ShapeCase> {};

TEST_P(BlockShapes, boxes_are_those_of_the_game) {
  Boxes expected = GetParam().expected;
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(boxes(GetParam().state), expected);
}

const ShapeCase kSlabs[] = {
    {"oak_slab[type=bottom]", {"0 0 0 16 8 16"}},
    {"oak_slab[type=top]", {"0 8 0 16 16 16"}},
    {"oak_slab[type=double]", {"0 0 0 16 16 16"}},
    {"cobblestone_slab", {"0 0 0 16 8 16"}},
};
INSTANTIATE_TEST_SUITE_P(slabs, BlockShapes, testing::ValuesIn(kSlabs));

// Facing is the way one climbs; left and right are as seen facing that way.
const ShapeCase kStairs[] = {
    {"oak_stairs[facing=north]", {"0 0 0 16 8 16", "0 8 0 16 16 8"}},
    {"oak_stairs[facing=east]", {"0 0 0 16 8 16", "8 8 0 16 16 16"}},
    {"oak_stairs[facing=south]", {"0 0 0 16 8 16", "0 8 8 16 16 16"}},
    {"oak_stairs[facing=west]", {"0 0 0 16 8 16", "0 8 0 8 16 16"}},
    {"oak_stairs[facing=east,half=top]", {"0 8 0 16 16 16", "8 0 0 16 8 16"}},
    {"oak_stairs[facing=north,shape=inner_left]",
     {"0 0 0 16 8 16", "0 8 0 16 16 8", "0 8 8 8 16 16"}},
    {"oak_stairs[facing=north,shape=inner_right]",
     {"0 0 0 16 8 16", "0 8 0 16 16 8", "8 8 8 16 16 16"}},
    {"oak_stairs[facing=east,shape=inner_right]",
     {"0 0 0 16 8 16", "8 8 0 16 16 16", "0 8 8 8 16 16"}},
    {"oak_stairs[facing=east,shape=outer_right]", {"0 0 0 16 8 16", "8 8 8 16 16 16"}},
    {"oak_stairs[facing=north,shape=outer_left]", {"0 0 0 16 8 16", "0 8 0 8 16 8"}},
    {"oak_stairs[facing=south,shape=outer_left]", {"0 0 0 16 8 16", "8 8 8 16 16 16"}},
    {"oak_stairs[facing=west,half=top,shape=outer_right]", {"0 8 0 16 16 16", "0 0 0 8 8 8"}},
    {"oak_stairs[facing=south,half=top,shape=inner_left]",
     {"0 8 0 16 16 16", "0 0 8 16 8 16", "8 0 0 16 8 8"}},
};
INSTANTIATE_TEST_SUITE_P(stairs, BlockShapes, testing::ValuesIn(kStairs));

const ShapeCase kConnected[] = {
    {"glass_pane", {"7 0 7 9 16 9"}},
    {"glass_pane[north=true,east=true]", {"7 0 7 9 16 9", "7 0 0 9 16 7", "9 0 7 16 16 9"}},
    {"iron_bars[south=true,west=true]", {"7 0 7 9 16 9", "7 0 9 9 16 16", "0 0 7 7 16 9"}},
    {"oak_fence[north=true]", {"6 0 6 10 16 10", "7 12 0 9 15 6", "7 6 0 9 9 6"}},
    {"oak_fence[west=true]", {"6 0 6 10 16 10", "0 12 7 6 15 9", "0 6 7 6 9 9"}},
    {"cobblestone_wall[up=true]", {"4 0 4 12 16 12"}},
    {"cobblestone_wall[up=false,east=low,west=tall]", {"8 0 5 16 14 11", "0 0 5 8 16 11"}},
    {"cobblestone_wall[up=true,north=true]", {"4 0 4 12 16 12", "5 0 0 11 14 8"}},
    {"vine[north=true,up=true]", {"0 0 0.8 16 16 0.8", "0 15.2 0 16 15.2 16"}},
};
INSTANTIATE_TEST_SUITE_P(connected, BlockShapes, testing::ValuesIn(kConnected));

const ShapeCase kDoors[] = {
    {"oak_door[facing=north]", {"0 0 13 16 16 16"}},
    {"oak_door[facing=east]", {"0 0 0 3 16 16"}},
    {"oak_door[facing=south]", {"0 0 0 16 16 3"}},
    {"oak_door[facing=west]", {"13 0 0 16 16 16"}},
    {"oak_door[facing=east,open=true,hinge=left]", {"0 0 0 16 16 3"}},
    {"oak_door[facing=east,open=true,hinge=right]", {"0 0 13 16 16 16"}},
    {"oak_door[facing=south,open=true,hinge=left]", {"13 0 0 16 16 16"}},
    {"oak_trapdoor[facing=south,open=true]", {"0 0 0 16 16 3"}},
    {"oak_trapdoor[facing=east,half=bottom]", {"0 0 0 16 3 16"}},
    {"oak_trapdoor[facing=east,half=top]", {"0 13 0 16 16 16"}},
    {"oak_fence_gate[facing=east]",
     {"7 5 0 9 16 2", "7 5 14 9 16 16", "7 6 6 9 15 10", "7 6 2 9 9 6", "7 6 10 9 9 14",
      "7 12 2 9 15 6", "7 12 10 9 15 14"}},
};
INSTANTIATE_TEST_SUITE_P(doors, BlockShapes, testing::ValuesIn(kDoors));

const ShapeCase kThings[] = {
    {"torch", {"7 0 7 9 10 9"}},
    {"wall_torch[facing=east]", {"0 3 7 2 13 9"}},
    {"lantern", {"5 0 5 11 7 11", "6 7 6 10 9 10"}},
    {"lantern[hanging=true]", {"5 1 5 11 8 11", "6 8 6 10 10 10", "7.5 10 7.5 8.5 16 8.5"}},
    {"red_carpet", {"0 0 0 16 1 16"}},
    {"snow[layers=3]", {"0 0 0 16 6 16"}},
    {"snow[layers=8]", {"0 0 0 16 16 16"}},
    {"cactus", {"1 0 1 15 16 15"}},
    {"farmland", {"0 0 0 16 15 16"}},
    {"dirt_path", {"0 0 0 16 15 16"}},
    {"ladder[facing=east]", {"0.8 0 0 0.8 16 16"}},
    {"oak_pressure_plate", {"1 0 1 15 1 15"}},
    {"oak_button[face=floor,facing=east]", {"6 0 5 10 2 11"}},
    {"chain[axis=x]", {"0 6.5 8 16 9.5 8", "0 8 6.5 16 8 9.5"}},
    {"end_rod[facing=north]", {"6 6 15 10 10 16", "7 7 0 9 9 15"}},
    {"end_rod[facing=down]", {"6 15 6 10 16 10", "7 0 7 9 15 9"}},
    {"chest[facing=south,type=left]", {"0 0 1 15 14 15", "0 7 15 1 11 16"}},
    {"red_bed[facing=north,part=foot]", {"0 3 0 16 9 16", "0 0 13 3 3 16", "13 0 13 16 3 16"}},
    {"anvil[facing=east]", {"2 0 2 14 4 14", "3 4 4 13 5 12", "4 5 6 12 10 10", "0 10 3 16 16 13"}},
    {"oak_sign[rotation=0]", {"0 9 7.25 16 16 8.75", "7.25 0 7.25 8.75 9 8.75"}},
    {"oak_sign[rotation=4]", {"7.25 9 0 8.75 16 16", "7.25 0 7.25 8.75 9 8.75"}},
    {"lily_pad", {"0 0.25 0 16 0.25 16"}},
    {"water[level=8]", {"0 0 0 16 16 16"}},
};
INSTANTIATE_TEST_SUITE_P(things, BlockShapes, testing::ValuesIn(kThings));

ShapeBox firstBox(const std::string& state) {
  return BlockTable().factsOf(*parseBlockState(state)).boxes.at(0);
}

std::string textureOf(const ShapeBox& box, FaceDirection face) { return box.textures[int(face)]; }

TEST(BlockShape, lying_log_turns_its_ends_and_its_bark) {
  const ShapeBox up = firstBox("oak_log[axis=y]");
  EXPECT_EQ(textureOf(up, FaceDirection::Up), "oak_log_top");
  EXPECT_EQ(textureOf(up, FaceDirection::North), "oak_log");
  const ShapeBox alongX = firstBox("oak_log[axis=x]");
  EXPECT_EQ(textureOf(alongX, FaceDirection::East), "oak_log_top");
  EXPECT_EQ(textureOf(alongX, FaceDirection::West), "oak_log_top");
  EXPECT_EQ(textureOf(alongX, FaceDirection::Up), "oak_log@90");
  EXPECT_EQ(textureOf(alongX, FaceDirection::North), "oak_log@90");
  const ShapeBox alongZ = firstBox("oak_log[axis=z]");
  EXPECT_EQ(textureOf(alongZ, FaceDirection::South), "oak_log_top");
  EXPECT_EQ(textureOf(alongZ, FaceDirection::Up), "oak_log");
  EXPECT_EQ(textureOf(alongZ, FaceDirection::East), "oak_log@90");
}

TEST(BlockShape, furnace_shows_its_front_where_it_faces) {
  const ShapeBox box = firstBox("furnace[facing=west,lit=true]");
  EXPECT_EQ(textureOf(box, FaceDirection::West), "furnace_front_on");
  EXPECT_EQ(textureOf(box, FaceDirection::East), "furnace_side");
  EXPECT_EQ(textureOf(box, FaceDirection::Up), "furnace_top");
  EXPECT_EQ(textureOf(firstBox("furnace[facing=up]"), FaceDirection::Up), "furnace_front");
}

TEST(BlockShape, faces_inside_the_shape_are_left_out) {
  const BlockFacts stairs = BlockTable().factsOf(*parseBlockState("oak_stairs[facing=north]"));
  ASSERT_EQ(stairs.boxes.size(), 2u);
  EXPECT_EQ(textureOf(stairs.boxes[1], FaceDirection::Down), "");
  EXPECT_EQ(textureOf(stairs.boxes[0], FaceDirection::Up), "oak_planks") << "half of it shows";
  const BlockFacts fence = BlockTable().factsOf(*parseBlockState("oak_fence[north=true]"));
  EXPECT_EQ(textureOf(fence.boxes[1], FaceDirection::South), "");
  EXPECT_EQ(textureOf(fence.boxes[1], FaceDirection::North), "oak_planks");
}

TEST(BlockShape, plane_has_two_faces) {
  const ShapeBox box = firstBox("ladder[facing=north]");
  int faces = 0;
  for (const std::string& texture : box.textures) faces += texture.empty() ? 0 : 1;
  EXPECT_EQ(faces, 2);
  EXPECT_EQ(textureOf(box, FaceDirection::North), "ladder");
  EXPECT_EQ(textureOf(box, FaceDirection::South), "ladder");
}

std::string covered(const std::string& state) {
  const BlockFacts facts = BlockTable().factsOf(*parseBlockState(state));
  const char* const names[] = {"down", "up", "north", "south", "west", "east"};
  std::string result;
  for (int face = 0; face < 6; ++face) {
    if (facts.coveredFaces & (1 << face)) result += std::string(names[face]) + " ";
  }
  return result;
}

TEST(BlockShape, covered_faces_hide_what_is_behind) {
  EXPECT_EQ(covered("stone"), "down up north south west east ");
  EXPECT_EQ(covered("oak_slab[type=bottom]"), "down ");
  EXPECT_EQ(covered("oak_slab[type=top]"), "up ");
  EXPECT_EQ(covered("oak_stairs[facing=east]"), "down east ");
  EXPECT_EQ(covered("oak_stairs[facing=east,half=top]"), "up east ");
  EXPECT_EQ(covered("oak_stairs[facing=north,shape=inner_left]"), "down north west ");
  EXPECT_EQ(covered("oak_stairs[facing=north,shape=outer_left]"), "down ");
  EXPECT_EQ(covered("glass"), "");
  EXPECT_EQ(covered("oak_leaves"), "");
  EXPECT_EQ(covered("oak_fence"), "");
  EXPECT_EQ(covered("farmland"), "down ");
}

}  // namespace
}  // namespace orris
