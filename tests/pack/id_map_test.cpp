#include <orris/pack/ids/id_map.h>

#include <gtest/gtest.h>

#include <orris/pack/ids/block_tags.h>
#include <orris/pack/ids/legacy_ids.h>

namespace orris {
namespace {

BlockIdMap parseIds(const std::string& text) {
  Diagnostics diagnostics;
  BlockIdMap map = parseBlockProperties("/block.properties", text, text, diagnostics);
  EXPECT_TRUE(diagnostics.empty()) << formatDiagnostic(diagnostics[0]);
  return map;
}

TEST(BlockIdMap, names_have_the_namespace_minecraft_unless_given) {
  const BlockIdMap map = parseIds("block.5 = stone mod:lamp\n");
  EXPECT_EQ(map.idOf("minecraft:stone", {}), 5);
  EXPECT_EQ(map.idOf("mod:lamp", {}), 5);
  EXPECT_EQ(map.idOf("minecraft:lamp", {}), -1);
  EXPECT_TRUE(map.present);
}

TEST(BlockIdMap, listed_properties_must_match_and_others_are_free) {
  const BlockIdMap map = parseIds(
      "block.1 = oak_stairs:half=top:facing=north,south\nblock.2 = minecraft:oak_stairs\n");
  EXPECT_EQ(map.idOf("minecraft:oak_stairs",
                     {{"half", "top"}, {"facing", "south"}, {"shape", "straight"}}),
            1);
  EXPECT_EQ(map.idOf("minecraft:oak_stairs", {{"half", "top"}, {"facing", "east"}}), 2);
  EXPECT_EQ(map.idOf("minecraft:oak_stairs", {{"facing", "north"}}), 2);
}

TEST(BlockIdMap, first_id_wins_and_a_repeated_key_replaces) {
  EXPECT_EQ(parseIds("block.7 = stone\nblock.3 = stone\n").idOf("minecraft:stone", {}), 7);
  const BlockIdMap map = parseIds("block.7 = stone\nblock.3 = dirt\nblock.7 = dirt\n");
  EXPECT_EQ(map.idOf("minecraft:dirt", {}), 7);
  EXPECT_EQ(map.idOf("minecraft:stone", {}), -1);
}

TEST(BlockIdMap, a_named_block_wins_over_a_tag_before_it) {
  const BlockIdMap map =
      parseIds("block.1 = %leaves\nblock.2 = oak_leaves\nblock.3 = %minecraft:logs:axis=y\n");
  EXPECT_EQ(map.idOf("minecraft:birch_leaves", {}), 1);
  EXPECT_EQ(map.idOf("minecraft:oak_leaves", {}), 2);
  EXPECT_EQ(map.idOf("minecraft:oak_log", {{"axis", "y"}}), 3);
  EXPECT_EQ(map.idOf("minecraft:oak_log", {{"axis", "x"}}), -1);
}

TEST(BlockIdMap, continued_lines_may_hold_gaps) {
  const BlockIdMap map = parseIds("block.1 = stone \\  \n\n  dirt \nblock.2 = glass\n");
  EXPECT_EQ(map.idOf("minecraft:dirt", {}), 1);
  EXPECT_EQ(map.idOf("minecraft:glass", {}), 2);
}

TEST(BlockIdMap, render_layers) {
  const BlockIdMap map = parseIds("layer.cutout_mipped = glass\nlayer.translucent = mod:ice\n");
  EXPECT_EQ(map.renderLayers.at("minecraft:glass"), "cutout");
  EXPECT_EQ(map.renderLayers.at("mod:ice"), "translucent");
}

TEST(BlockIdMap, without_a_file_blocks_have_their_old_numbers) {
  const BlockIdMap map = legacyBlockIds(12101);
  EXPECT_FALSE(map.present);
  EXPECT_EQ(map.idOf("minecraft:granite", {}), 1);
  EXPECT_EQ(map.idOf("minecraft:light_gray_wool", {}), 35);
  EXPECT_EQ(map.idOf("minecraft:dark_oak_leaves", {}), 18);
  EXPECT_EQ(map.idOf("minecraft:red_stained_glass_pane", {}), 160);
  EXPECT_EQ(map.idOf("minecraft:bedrock", {}), -1);
  // Iris: LegacyIdMap lists the old name only.
  EXPECT_EQ(map.idOf("minecraft:short_grass", {}), -1);
  EXPECT_EQ(legacyBlockIds(12002).idOf("minecraft:short_grass", {}), 31);
}

TEST(IdProperties, later_lines_win_and_states_are_skipped) {
  Diagnostics diagnostics;
  const std::string text = "item.1 = torch lantern\nitem.2 = torch bow:pull=1\n";
  const auto ids = parseIdProperties("/item.properties", text, text, "item.", diagnostics);
  EXPECT_EQ(ids, (std::map<std::string, int>{{"minecraft:lantern", 1}, {"minecraft:torch", 2}}));
}

TEST(BlockTags, exceptions_stand_before_the_rule) {
  EXPECT_TRUE(hasBlockTag("minecraft:oak_button", "minecraft:wooden_buttons"));
  EXPECT_FALSE(hasBlockTag("minecraft:stone_button", "wooden_buttons"));
  EXPECT_FALSE(hasBlockTag("minecraft:white_glazed_terracotta", "terracotta"));
  EXPECT_TRUE(hasBlockTag("terracotta", "terracotta"));
  EXPECT_FALSE(hasBlockTag("stone", "no_such_tag"));
  EXPECT_FALSE(isKnownBlockTag("no_such_tag"));
}

}  // namespace
}  // namespace orris
