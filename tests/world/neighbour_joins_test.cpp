#include <gtest/gtest.h>
#include <orris/world/blocks/neighbour_joins.h>

#include "world_helpers.h"

namespace orris {
namespace {

using Placed = std::vector<std::pair<glm::ivec3, std::string>>;

/// What becomes of the block at the middle, (1, 1, 1), without its namespace.
std::string joinedAs(const std::string& state, const Placed& beside,
                     void (*join)(BlockWorld&) = joinSides) {
  Scene scene(glm::ivec3(3));
  scene.set({1, 1, 1}, state);
  for (const auto& [at, block] : beside) scene.set(at, block);
  join(scene.blocks);
  return scene.blocks.at({1, 1, 1}).toString().substr(std::string("minecraft:").size());
}

constexpr glm::ivec3 kNorth(1, 1, 0), kEast(2, 1, 1), kSouth(1, 1, 2), kWest(0, 1, 1),
    kAbove(1, 2, 1);

/// The sides that are joined, as letters.
std::string sidesOf(const std::string& state, const Placed& beside) {
  const BlockState joined = blockState(joinedAs(state, beside));
  std::string sides;
  for (const char* side : {"north", "east", "south", "west"}) {
    const auto value = joined.property(side);
    if (value == "true" || value == "low") sides += side[0];
  }
  return sides;
}

TEST(NeighbourJoins, a_side_has_the_direction_of_what_it_meets) {
  EXPECT_EQ(joinedAs("oak_fence", {{kEast, "stone"}}),
            "oak_fence[east=true,north=false,south=false,west=false]");
  EXPECT_EQ(sidesOf("oak_fence", {{kNorth, "stone"}}), "n");
  EXPECT_EQ(sidesOf("oak_fence", {{kSouth, "stone"}}), "s");
  EXPECT_EQ(sidesOf("oak_fence", {{kWest, "stone"}}), "w");
  EXPECT_EQ(sidesOf("oak_fence", {{kAbove, "stone"}}), "");
}

TEST(NeighbourJoins, fences_walls_and_panes_meet_what_the_game_has_them_meet) {
  struct Row {
    const char *state, *beside;
    bool meets;
  };
  const Row rows[] = {{"oak_fence", "birch_fence", true},
                      {"oak_fence", "nether_brick_fence", false},
                      {"nether_brick_fence", "nether_brick_fence", true},
                      {"oak_fence", "cobblestone_wall", false},
                      {"oak_fence", "oak_fence_gate[facing=north]", true},
                      {"oak_fence", "oak_fence_gate[facing=east]", false},
                      {"oak_fence", "glass", true},
                      {"oak_fence", "oak_leaves", false},
                      {"oak_fence", "melon", false},
                      {"oak_fence", "water", false},
                      {"oak_fence", "poppy", false},
                      {"oak_fence", "air", false},
                      {"oak_fence", "oak_slab", false},
                      {"oak_fence", "oak_stairs[facing=west]", true},
                      {"oak_fence", "oak_stairs[facing=east]", false},
                      {"cobblestone_wall", "granite_wall", true},
                      {"cobblestone_wall", "iron_bars", true},
                      {"cobblestone_wall", "oak_fence", false},
                      {"cobblestone_wall", "oak_fence_gate[facing=south]", true},
                      {"glass_pane", "iron_bars", true},
                      {"glass_pane", "red_stained_glass_pane", true},
                      {"glass_pane", "cobblestone_wall", true},
                      {"glass_pane", "oak_fence_gate[facing=north]", false},
                      {"iron_bars", "stone", true}};
  for (const Row& row : rows)
    EXPECT_EQ(sidesOf(row.state, {{kEast, row.beside}}), row.meets ? "e" : "")
        << row.state << ' ' << row.beside;
}

TEST(NeighbourJoins, a_wall_that_goes_straight_on_has_no_post) {
  const auto post = [](const Placed& beside) {
    return std::string(blockState(joinedAs("cobblestone_wall", beside)).property("up"));
  };
  EXPECT_EQ(post({}), "true");
  EXPECT_EQ(post({{kNorth, "stone"}, {kSouth, "stone"}}), "false");
  EXPECT_EQ(post({{kEast, "stone"}, {kWest, "stone"}}), "false");
  EXPECT_EQ(post({{kEast, "stone"}, {kWest, "stone"}, {kAbove, "torch"}}), "true");
  EXPECT_EQ(post({{kEast, "stone"}, {kSouth, "stone"}}), "true");
  EXPECT_EQ(post({{kEast, "stone"}}), "true");
  EXPECT_EQ(post({{kNorth, "stone"}, {kEast, "stone"}, {kSouth, "stone"}, {kWest, "stone"}}),
            "true");
}

TEST(NeighbourJoins, rails_lie_towards_each_other) {
  const auto shape = [](const Placed& beside, const std::string& rail = "rail") {
    return std::string(blockState(joinedAs(rail, beside)).property("shape"));
  };
  EXPECT_EQ(shape({}), "north_south");
  EXPECT_EQ(shape({{kEast, "powered_rail"}}), "east_west");
  EXPECT_EQ(shape({{kSouth, "rail"}, {kWest, "rail"}}), "south_west");
  EXPECT_EQ(shape({{kNorth, "rail"}, {kEast, "rail"}}), "north_east");
  EXPECT_EQ(shape({{kNorth, "rail"}, {kEast, "rail"}}, "powered_rail"), "north_south")
      << "no curves";
  EXPECT_EQ(shape({{kEast + glm::ivec3(0, 1, 0), "rail"}}), "ascending_east");
  EXPECT_EQ(shape({{kWest - glm::ivec3(0, 1, 0), "rail"}}), "east_west");
  EXPECT_EQ(shape({{kNorth, "rail"}, {kEast, "rail"}}, "rail[shape=east_west]"), "east_west");
}

TEST(NeighbourJoins, what_a_state_names_stays) {
  EXPECT_EQ(joinedAs("oak_fence[north=true]", {{kEast, "stone"}}), "oak_fence[north=true]");
  EXPECT_EQ(joinedAs("oak_fence_gate", {{kEast, "stone"}}), "oak_fence_gate");
  EXPECT_EQ(joinedAs("oak_stairs[facing=north,half=bottom,shape=straight]",
                     {{kNorth, "oak_stairs[facing=west,half=bottom]"}}, completeParts),
            "oak_stairs[facing=north,half=bottom,shape=straight]");
}

TEST(NeighbourJoins, stairs_turn_corners) {
  const auto shape = [](const Placed& beside) {
    return std::string(
        blockState(joinedAs("oak_stairs[facing=north,half=bottom]", beside, completeParts))
            .property("shape"));
  };
  const std::string west = "oak_stairs[facing=west,half=bottom]",
                    east = "stone_stairs[facing=east,half=bottom]";
  EXPECT_EQ(shape({}), "straight");
  EXPECT_EQ(shape({{kNorth, west}}), "outer_left");
  EXPECT_EQ(shape({{kNorth, east}}), "outer_right");
  EXPECT_EQ(shape({{kSouth, west}}), "inner_left");
  EXPECT_EQ(shape({{kSouth, east}}), "inner_right");
  EXPECT_EQ(shape({{kNorth, "oak_stairs[facing=west,half=top]"}}), "straight");
  EXPECT_EQ(shape({{kNorth, "oak_stairs[facing=south,half=bottom]"}}), "straight");
  EXPECT_EQ(shape({{kNorth, west}, {kEast, "oak_stairs[facing=north,half=bottom]"}}), "straight")
      << "the row goes on where the corner would be";
}

TEST(NeighbourJoins, halves_know_of_each_other) {
  const std::string lower = "oak_door[facing=east,half=lower,open=true]",
                    upper = "oak_door[half=upper,hinge=right]";
  EXPECT_EQ(joinedAs(lower, {{kAbove, upper}}, completeParts),
            "oak_door[facing=east,half=lower,hinge=right,open=true]");
  EXPECT_EQ(joinedAs(upper, {{{1, 0, 1}, lower}}, completeParts),
            "oak_door[facing=east,half=upper,hinge=right,open=true]");
  EXPECT_EQ(joinedAs(upper, {{{1, 0, 1}, "stone"}}, completeParts),
            "oak_door[half=upper,hinge=right]");
  EXPECT_EQ(
      joinedAs("sunflower[half=upper]", {{{1, 0, 1}, "rose_bush[half=lower]"}}, completeParts),
      "rose_bush[half=upper]");
  EXPECT_EQ(joinedAs("rose_bush[half=lower]", {{kAbove, "sunflower[half=upper]"}}, completeParts),
            "rose_bush[half=lower]");
}

TEST(NeighbourJoins, chests_beside_each_other_are_one) {
  const std::string chest = "chest[facing=north]";
  EXPECT_EQ(joinedAs(chest, {{kEast, chest}}, completeParts), "chest[facing=north,type=left]");
  EXPECT_EQ(joinedAs(chest, {{kWest, chest}}, completeParts), "chest[facing=north,type=right]");
  EXPECT_EQ(
      joinedAs(chest, {{kWest, "chest[facing=south]"}, {kEast, "trapped_chest[facing=north]"}},
               completeParts),
      "chest[facing=north,type=single]");
}

TEST(NeighbourJoins, whole_sections_of_one_state_join_too) {
  Scene scene(glm::ivec3(48, 16, 16));
  scene.fill({16, 0, 0}, {31, 15, 15}, "oak_fence");
  joinSides(scene.blocks);
  EXPECT_EQ(scene.blocks.at({20, 3, 3}).toString(),
            "minecraft:oak_fence[east=true,north=true,south=true,west=true]");
  EXPECT_EQ(scene.blocks.at({16, 3, 0}).toString(),
            "minecraft:oak_fence[east=true,north=false,south=true,west=false]");
}

}  // namespace
}  // namespace orris
