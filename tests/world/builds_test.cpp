// Structures, Litematica's files and schematics of numeric ids.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "region_builder.h"
#include <orris/world/files/schematic.h>
#include <orris/world/saves/legacy_blocks.h>
#include "world_helpers.h"

namespace orris {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::optional<BlockWorld> built(const std::string& members, std::string& errors) {
  Diagnostics diagnostics;
  auto world = parseSchematic(gzip(nbtCompound("", members)), "a.nbt", diagnostics);
  errors = diagnostics.empty() ? "" : diagnostics[0].message;
  return world;
}

std::string intList(const std::string& name, const std::vector<int>& values) {
  std::vector<std::string> items;
  for (const int value : values) items.push_back(bigEndian(std::uint64_t(value), 4));
  return nbtList(name, 3, items);
}
std::string triple(const std::string& name, glm::ivec3 v) {
  return nbtCompound(name, nbtInt("x", v.x) + nbtInt("y", v.y) + nbtInt("z", v.z));
}
std::string entries(const std::string& name, const std::vector<std::string>& states) {
  std::vector<std::string> items;
  for (const std::string& state : states) items.push_back(paletteEntry(state));
  return nbtList(name, 10, items);
}

std::string structure(const std::vector<std::pair<glm::ivec3, int>>& blocks) {
  std::vector<std::string> items;
  for (const auto& [at, state] : blocks)
    items.push_back(closed(intList("pos", {at.x, at.y, at.z}) + nbtInt("state", state)));
  return intList("size", {3, 2, 2}) +
         entries("palette", {"minecraft:stone", "minecraft:oak_log[axis=x]"}) +
         nbtList("blocks", 10, items);
}

TEST(Builds, structure_sets_the_blocks_it_lists) {
  std::string errors;
  const auto world = built(structure({{{0, 0, 0}, 0}, {{2, 1, 1}, 1}}), errors);
  ASSERT_TRUE(world) << errors;
  EXPECT_EQ(world->size(), glm::ivec3(3, 2, 2));
  EXPECT_EQ(world->at({0, 0, 0}).name, "minecraft:stone");
  EXPECT_EQ(world->at({2, 1, 1}).toString(), "minecraft:oak_log[axis=x]");
  EXPECT_EQ(world->at({1, 0, 0}).name, "minecraft:air");
}

TEST(Builds, structure_with_blocks_elsewhere_is_refused) {
  std::string errors;
  EXPECT_FALSE(built(structure({{{3, 0, 0}, 0}}), errors));
  EXPECT_EQ(errors, "block (3, 0, 0) lies outside of the size");
  EXPECT_FALSE(built(structure({{{0, 0, 0}, -1}}), errors));
  EXPECT_EQ(errors, "block (0, 0, 0) has palette index -1: expected 0 to 1");
}

std::string region(const std::string& name, glm::ivec3 position, glm::ivec3 size,
                   const std::vector<int>& indices) {
  return nbtCompound(
      name, triple("Position", position) + triple("Size", size) +
                entries("BlockStatePalette", {"minecraft:air", "minecraft:stone", "minecraft:dirt",
                                              "minecraft:sand", "minecraft:clay"}) +
                nbtLongs("BlockStates", packIndices(indices, 3, true)));
}
std::string litematic(const std::string& regions) {
  return nbtInt("Version", 6) + nbtCompound("Regions", regions);
}

TEST(Builds, litematic_joins_regions_of_positive_and_negative_size) {
  std::vector<int> indices(3 * 3 * 3, 1);
  indices[(1 * 3 + 2) * 3 + 0] = 4;  // x 0, y 1, z 2: across two numbers
  std::string errors;
  const auto world = built(litematic(region("a", {10, 5, 0}, {3, 3, 3}, indices) +
                                     region("b", {9, 5, 0}, {-2, 1, 1}, {2, 3})),
                           errors);
  ASSERT_TRUE(world) << errors;
  EXPECT_EQ(world->size(), glm::ivec3(5, 3, 3));
  EXPECT_EQ(world->at({0, 0, 0}).name, "minecraft:dirt");
  EXPECT_EQ(world->at({1, 0, 0}).name, "minecraft:sand");
  EXPECT_EQ(world->at({2, 1, 2}).name, "minecraft:clay");
  EXPECT_EQ(world->at({4, 2, 2}).name, "minecraft:stone");
  EXPECT_EQ(world->at({0, 1, 0}).name, "minecraft:air");
}

TEST(Builds, litematic_that_promises_too_much_is_refused) {
  std::string errors;
  EXPECT_FALSE(built(litematic(region("a", {0, 0, 0}, {3, 3, 3}, {1})), errors));
  EXPECT_EQ(errors, "region \"a\": \"BlockStates\" has 1 numbers: expected 2 for 27 blocks");
  EXPECT_FALSE(built(litematic(region("a", {0, 0, 0}, {1, 1, 1}, {7})), errors));
  EXPECT_EQ(errors, "region \"a\": a block has palette index 7: expected 0 to 4");
  EXPECT_FALSE(built(litematic(region("a", {0, 0, 0}, {1, 1, 0}, {})), errors));
  EXPECT_EQ(errors, "the region \"a\" has no \"Position\" and \"Size\" of 1 to 512 blocks");
  EXPECT_FALSE(built(
      litematic(region("a", {0, 0, 0}, {1, 1, 1}, {1}) + region("b", {0, 4000, 0}, {1, 1, 1}, {1})),
      errors));
  EXPECT_EQ(errors, "1 x 4001 x 1 blocks: expected 1 to 512 along each axis");
  EXPECT_FALSE(built(litematic(""), errors));
  EXPECT_EQ(errors, "no regions");
}

TEST(Builds, numeric_schematic_maps_ids_and_data) {
  const std::string size = nbtShort("Width", 2) + nbtShort("Height", 1) + nbtShort("Length", 2);
  std::string errors;
  // Red wool, upper oak slab; stairs to the west, upside down; an id of a mod.
  const auto world = built(size + nbtString("Materials", "Alpha") +
                               nbtByteArray("Blocks", {"\x23\x7e\x35\x01", 4}) +
                               nbtByteArray("Data", {"\x0e\x08\x05\x00", 4}) +
                               nbtByteArray("AddBlocks", {"\x00\x10", 2}),
                           errors);
  ASSERT_TRUE(world) << errors;
  EXPECT_EQ(world->at({0, 0, 0}).name, "minecraft:red_wool");
  EXPECT_EQ(world->at({1, 0, 0}).toString(), "minecraft:oak_slab[type=top]");
  EXPECT_EQ(world->at({0, 0, 1}).toString(), "minecraft:oak_stairs[facing=west,half=top,shape=straight]");
  EXPECT_EQ(world->at({1, 0, 1}).name, "legacy:257");
  EXPECT_FALSE(built(size + nbtByteArray("Blocks", "12") + nbtByteArray("Data", "12"), errors));
  EXPECT_EQ(errors, "\"Blocks\" and \"Data\" have fewer than 4 bytes each");
}

TEST(Builds, numeric_schematic_joins_its_fences) {
  std::string errors;
  const auto world = built(nbtShort("Width", 2) + nbtShort("Height", 1) + nbtShort("Length", 1) +
                               nbtByteArray("Blocks", "\x55\x55") + nbtByteArray("Data", {"\0\0", 2}),
                           errors);
  ASSERT_TRUE(world) << errors;
  EXPECT_THAT(world->at({0, 0, 0}).toString(), HasSubstr("east=true"));
  EXPECT_THAT(world->at({1, 0, 0}).toString(), AllOf(HasSubstr("east=false"), HasSubstr("west=true")));
}

TEST(LegacyBlocks, every_state_of_the_table_is_known_to_the_block_data) {
  const BlockTable table;
  std::set<std::string> unknown;
  int known = 0;
  for (int id = 0; id < 256; ++id) {
    for (int data = 0; data < 16; ++data) {
      const BlockState state = legacyState(id, data);
      EXPECT_TRUE(parseBlockState(state.toString())) << state.toString();
      if (state.name.starts_with("legacy:")) continue;
      ++known;
      if (!table.factsOf(state).known) unknown.insert(state.name);
    }
  }
  EXPECT_GT(known, 245 * 16);
  EXPECT_EQ(unknown, std::set<std::string>{});
}

TEST(LegacyBlocks, data_turns_and_opens) {
  EXPECT_EQ(legacyState(17, 5).toString(), "minecraft:spruce_log[axis=x]");
  EXPECT_EQ(legacyState(50, 1).toString(), "minecraft:wall_torch[facing=east]");
  EXPECT_EQ(legacyState(50, 5).toString(), "minecraft:torch");
  EXPECT_EQ(legacyState(64, 4).toString(), "minecraft:oak_door[facing=east,half=lower,open=true]");
  EXPECT_EQ(legacyState(26, 9).toString(), "minecraft:red_bed[facing=west,part=head]");
  EXPECT_EQ(legacyState(98, 2).toString(), "minecraft:cracked_stone_bricks");
  EXPECT_EQ(legacyState(98, 0).toString(), "minecraft:stone_bricks");
  EXPECT_EQ(legacyState(251, 15).toString(), "minecraft:black_concrete");
  EXPECT_EQ(legacyState(9, 3).toString(), "minecraft:water[level=3]");
}

}  // namespace
}  // namespace orris
