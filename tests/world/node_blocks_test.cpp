#include <orris/world/luanti/node_blocks.h>

#include <gtest/gtest.h>

#include <orris/world/blocks/block_data.h>

namespace orris {
namespace {

std::string blockText(const std::string& node, int param2 = 0) {
  const auto state = blockOfNode(node, std::uint8_t(param2));
  return state ? state->toString().substr(std::string("minecraft:").size()) : "unknown";
}

TEST(NodeBlocks, every_row_names_a_block_of_this_host) {
  for (const NodeRow& row : nodeRows()) {
    const auto state = parseBlockState(row.block);
    ASSERT_TRUE(state) << row.block;
    EXPECT_TRUE(definitionOf(state->name)) << row.node << ' ' << row.block;
    for (int param2 = 0; param2 < 256; ++param2) ASSERT_TRUE(blockOfNode(row.node, std::uint8_t(param2))) << row.node;
  }
  EXPECT_TRUE(definitionOf(kUnknownNodeBlock));
}

TEST(NodeBlocks, nodes_of_the_games) {
  EXPECT_EQ(blockText("default:dirt_with_grass"), "grass_block");
  EXPECT_EQ(blockText("default:water_source"), "water");
  EXPECT_EQ(blockText("mcl_core:stone"), "stone");
  EXPECT_EQ(blockText("mcl_core:dirt_with_grass"), "grass_block");
  EXPECT_EQ(blockText("mcl_nether:netherrack"), "netherrack");
  EXPECT_EQ(blockText("wool:dark_grey"), "gray_wool");
  EXPECT_EQ(blockText("wool:grey"), "light_gray_wool");
  EXPECT_EQ(blockText("mcl_wool:grey"), "gray_wool");
  EXPECT_EQ(blockText("mcl_wool:silver_carpet"), "light_gray_carpet");
  EXPECT_EQ(blockText("mcl_colorblocks:concrete_powder_red"), "red_concrete_powder");
  EXPECT_EQ(blockText("mcl_trees:leaves_dark_oak"), "dark_oak_leaves");
  EXPECT_EQ(blockText("ignore"), "air");
  for (const char* node : {"", ":", "mod:thing", "mcl_x:", "stairs:", "stairs:stair_", "wool:", "mcl_wool:_carpet", "mcl_core:a[b"})
    EXPECT_EQ(blockText(node), "unknown") << node;
}

// Sides keep their names. By the boxes of Minetest Game's nodes and Luanti's facedir.
TEST(NodeBlocks, stairs_and_slabs_turn_with_facedir) {
  const char* sides[] = {"north", "east", "south", "west"};
  for (int i = 0; i < 4; ++i)
    EXPECT_EQ(blockText("stairs:stair_cobble", i), "cobblestone_stairs[facing=" + std::string(sides[i]) + ",half=bottom]");
  EXPECT_EQ(blockText("stairs:stair_wood", 20), "oak_stairs[facing=north,half=top]");
  EXPECT_EQ(blockText("stairs:stair_wood", 21), "oak_stairs[facing=west,half=top]");
  EXPECT_EQ(blockText("stairs:stair_inner_wood", 1), "oak_stairs[facing=east,half=bottom,shape=inner_left]");
  EXPECT_EQ(blockText("stairs:stair_outer_wood", 22), "oak_stairs[facing=south,half=top,shape=outer_right]");
  EXPECT_EQ(blockText("mcl_stairs:stair_stonebrick_inner", 0), "stone_brick_stairs[facing=north,half=bottom,shape=inner_left]");
  EXPECT_EQ(blockText("stairs:slab_cobble", 3), "cobblestone_slab[type=bottom]");
  EXPECT_EQ(blockText("stairs:slab_cobble", 22), "cobblestone_slab[type=top]");
  EXPECT_EQ(blockText("mcl_stairs:slab_cobble_top"), "cobblestone_slab[type=top]");
  EXPECT_EQ(blockText("mcl_stairs:slab_cobble_double"), "cobblestone_slab[type=double]");
}

TEST(NodeBlocks, logs_lie_along_their_axis) {
  EXPECT_EQ(blockText("default:tree", 0), "oak_log[axis=y]");
  EXPECT_EQ(blockText("default:tree", 4), "oak_log[axis=z]");
  EXPECT_EQ(blockText("mcl_trees:tree_spruce", 12), "spruce_log[axis=x]");
  EXPECT_EQ(blockText("default:tree", 20), "oak_log[axis=y]");
}

TEST(NodeBlocks, what_hangs_on_a_wall_faces_away_from_it) {
  const char* away[] = {"west", "east", "south", "north"};
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(blockText("default:torch_wall", 2 + i), "wall_torch[facing=" + std::string(away[i]) + "]");
    EXPECT_EQ(blockText("default:ladder_wood", 2 + i), "ladder[facing=" + std::string(away[i]) + "]");
  }
}

TEST(NodeBlocks, fronts_are_opposite_of_backs) {
  EXPECT_EQ(blockText("default:chest", 0), "chest[facing=south]");
  EXPECT_EQ(blockText("default:furnace", 1), "furnace[facing=west]");
  EXPECT_EQ(blockText("doors:door_wood_a", 1), "oak_door[facing=east]");
}

TEST(NodeBlocks, flowing_liquids_have_a_height) {
  EXPECT_EQ(blockText("default:water_flowing", 7), "water[level=1]");
  EXPECT_EQ(blockText("default:water_flowing", 1), "water[level=7]");
  EXPECT_EQ(blockText("default:water_flowing", 0), "water[level=7]");
  EXPECT_EQ(blockText("default:lava_flowing", 8 + 7), "lava[level=8]");
}

}  // namespace
}  // namespace orris
