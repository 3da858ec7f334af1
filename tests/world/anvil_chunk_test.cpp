#include <orris/world/saves/anvil_chunk.h>

#include <gtest/gtest.h>

#include "region_builder.h"
#include <orris/world/saves/packed_indices.h>

namespace orris {
namespace {

SectionParts manyStates(int y, int states) {
  SectionParts parts{y};
  parts.palette = {"minecraft:air"};
  for (int i = 1; i < states; ++i) parts.palette.push_back("a:b" + std::to_string(i));
  for (int i = 0; i < 4096; ++i) parts.indices.push_back(i * 7 % states);
  return parts;
}

std::string problemOf(const ChunkParts& parts) {
  AnvilChunk chunk;
  std::string problem;
  EXPECT_EQ(parseAnvilChunk(parts.tags(), chunk, problem), ChunkOutcome::Unreadable);
  return problem;
}

class ChunkFormats : public testing::TestWithParam<ChunkFormat> {};

TEST_P(ChunkFormats, every_block_of_small_and_large_palettes_is_read) {
  for (const int states : {2, 16, 17, 33, 100, 257, 4096}) {
    ChunkParts parts;
    parts.format = GetParam();
    parts.sections = {manyStates(3, states)};
    AnvilChunk chunk;
    std::string problem;
    ASSERT_EQ(parseAnvilChunk(parts.tags(), chunk, problem), ChunkOutcome::Read) << problem;
    ASSERT_EQ(chunk.sections.size(), 1u);
    EXPECT_EQ(chunk.sections[0].y, 3);
    for (std::size_t i = 0; i < 4096; ++i)
      ASSERT_EQ(chunk.palette[chunk.sections[0].cells[i]].name,
                parts.sections[0].palette[i * 7 % std::size_t(states)])
          << states << " states, block " << i;
  }
}

INSTANTIATE_TEST_SUITE_P(All, ChunkFormats,
                         testing::Values(ChunkFormat::Across, ChunkFormat::Level116,
                                         ChunkFormat::Flat));

TEST(AnvilChunk, sections_below_zero_and_of_one_state_are_read_in_order) {
  ChunkParts parts;
  parts.sections = {
      stoneFloor(0), {-4, {"minecraft:bedrock"}, {}}, {-1, {"minecraft:cave_air"}, {}}};
  AnvilChunk chunk;
  std::string problem;
  ASSERT_EQ(parseAnvilChunk(parts.tags(), chunk, problem), ChunkOutcome::Read) << problem;
  ASSERT_EQ(chunk.sections.size(), 3u);
  EXPECT_EQ(chunk.sections[0].y, -4);
  EXPECT_EQ(chunk.palette[chunk.sections[0].only].name, "minecraft:bedrock");
  EXPECT_EQ(chunk.sections[1].only, 0) << "cave air is air";
  EXPECT_EQ(chunk.palette[chunk.sections[2].cells[255]].name, "minecraft:stone");
  EXPECT_EQ(chunk.sections[2].cells[256], 0);
  EXPECT_EQ(chunk.sections[2].biomes, std::vector<std::string>{"minecraft:desert"});
}

TEST(AnvilChunk, properties_of_states_are_read) {
  ChunkParts parts;
  parts.sections = {{0, {"minecraft:oak_stairs[facing=west,half=top]"}, {}}};
  AnvilChunk chunk;
  std::string problem;
  ASSERT_EQ(parseAnvilChunk(parts.tags(), chunk, problem), ChunkOutcome::Read) << problem;
  EXPECT_EQ(chunk.palette[chunk.sections[0].only].toString(),
            "minecraft:oak_stairs[facing=west,half=top]");
}

TEST(AnvilChunk, chunks_the_game_has_begun_are_unfinished) {
  ChunkParts parts;
  parts.status = "minecraft:features";
  AnvilChunk chunk;
  std::string problem;
  EXPECT_EQ(parseAnvilChunk(parts.tags(), chunk, problem), ChunkOutcome::Unfinished);
}

TEST(AnvilChunk, of_two_sections_at_one_height_the_later_is_taken) {
  ChunkParts parts;
  parts.sections = {{0, {"minecraft:dirt"}, {}}, {0, {"minecraft:sand"}, {}}};
  AnvilChunk chunk;
  std::string problem;
  ASSERT_EQ(parseAnvilChunk(parts.tags(), chunk, problem), ChunkOutcome::Read);
  ASSERT_EQ(chunk.sections.size(), 1u);
  EXPECT_EQ(chunk.palette[chunk.sections[0].only].name, "minecraft:sand");
}

TEST(AnvilChunk, what_does_not_fit_is_a_problem) {
  ChunkParts parts;
  parts.sections = {manyStates(0, 4)};
  parts.sections[0].indices[9] = 5;
  EXPECT_EQ(problemOf(parts), "a block of section 0 has palette index 5: expected 0 to 3");
  parts.sections = {manyStates(0, 4)};
  parts.sections[0].indices.resize(4000);
  EXPECT_EQ(problemOf(parts),
            "the blocks of section 0 take 250 numbers: expected 256 for 4 states");
  parts.sections = {{0, {"No Block"}, {}}};
  EXPECT_EQ(problemOf(parts), "\"No Block\" in its palette is not a block state");
  parts.sections = {{0, {"minecraft:stone", "minecraft:dirt"}, {}}};
  EXPECT_EQ(problemOf(parts), "section 0 has a palette but no blocks");
  parts.sections = {manyStates(0, 4097)};
  EXPECT_EQ(problemOf(parts), "the palette of a section has 4097 states: expected at most 4096");
}

TEST(AnvilChunk, numeric_ids_of_old_games_are_read) {
  std::string ids(4096, '\0'), data(2048, '\0'), add(2048, '\0');
  ids[0] = 35, data[0] = 14;      // red wool
  ids[1] = 1, data[0] |= 1 << 4;  // granite
  ids[2] = 1, add[1] = 1;         // 257, of a mod
  const std::string section = closed(nbtByte("Y", 2) + nbtByteArray("Blocks", ids) +
                                     nbtByteArray("Data", data) + nbtByteArray("Add", add));
  AnvilChunk chunk;
  std::string problem;
  const std::string tags =
      nbtCompound("", nbtCompound("Level", nbtList("Sections", 10, {section})));
  ASSERT_EQ(parseAnvilChunk(tags, chunk, problem), ChunkOutcome::Read) << problem;
  const std::vector<std::uint16_t>& cells = chunk.sections.at(0).cells;
  EXPECT_EQ(chunk.palette[cells[0]].name, "minecraft:red_wool");
  EXPECT_EQ(chunk.palette[cells[1]].name, "minecraft:granite");
  EXPECT_EQ(chunk.palette[cells[2]].name, "legacy:257");
  EXPECT_EQ(cells[3], 0);
}

TEST(AnvilChunk, every_truncation_is_unreadable) {
  ChunkParts parts;
  parts.sections = {stoneFloor(-4), stoneFloor(2)};
  const std::string tags = parts.tags();
  for (std::size_t length = 0; length + 1 < tags.size(); length += 13) {
    AnvilChunk chunk;
    std::string problem;
    EXPECT_EQ(parseAnvilChunk(tags.substr(0, length), chunk, problem), ChunkOutcome::Unreadable)
        << length;
  }
}

}  // namespace
}  // namespace orris
