#include <orris/world/files/schematic.h>

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "nbt_builder.h"
#include "world_helpers.h"

namespace orris {
namespace {

std::string errorOf(const std::string& bytes) {
  Diagnostics diagnostics;
  EXPECT_FALSE(parseSchematic(bytes, "a.schem", diagnostics));
  EXPECT_EQ(diagnostics.size(), 1u);
  return diagnostics.empty() ? "" : diagnostics[0].message;
}

std::string errorOf(const SchematicParts& parts) { return errorOf(parts.file()); }

std::optional<std::string> sharedSchematic() {
  std::ifstream stream(ORRIS_SOURCE_DIR "/../shared/worlds/smallhouse1.schem", std::ios::binary);
  if (!stream) return std::nullopt;
  std::ostringstream bytes;
  bytes << stream.rdbuf();
  return bytes.str();
}

TEST(Schematic, blocks_run_east_then_south_then_up) {
  SchematicParts parts;
  parts.height = 2;
  parts.data = {"\1\0\0\0\0\0\1\0", 8};
  Diagnostics diagnostics;
  const auto world = parseSchematic(parts.file(), "a.schem", diagnostics);
  ASSERT_TRUE(world) << joined(diagnostics);
  EXPECT_EQ(world->size(), glm::ivec3(2, 2, 2));
  EXPECT_EQ(world->at({0, 0, 0}).name, "minecraft:stone");
  EXPECT_EQ(world->at({0, 1, 1}).name, "minecraft:stone");
  EXPECT_EQ(world->at({1, 0, 0}).name, "minecraft:air");
}

TEST(Schematic, versions_1_and_3_are_read) {
  for (const int version : {1, 3}) {
    SchematicParts parts;
    parts.version = version;
    Diagnostics diagnostics;
    const auto world = parseSchematic(parts.file(), "a.schem", diagnostics);
    ASSERT_TRUE(world) << version << ": " << joined(diagnostics);
    EXPECT_EQ(world->at({1, 0, 0}).name, "minecraft:stone");
  }
}

TEST(Schematic, indices_over_127_take_two_bytes) {
  SchematicParts parts;
  parts.width = 1, parts.length = 1;
  parts.palette.clear();
  for (int i = 0; i < 200; ++i) parts.palette.emplace_back("a:b" + std::to_string(i), i);
  parts.data = "\xc7\x01";  // 199
  Diagnostics diagnostics;
  const auto world = parseSchematic(parts.file(), "a.schem", diagnostics);
  ASSERT_TRUE(world) << joined(diagnostics);
  EXPECT_EQ(world->at({0, 0, 0}).name, "a:b199");
}

TEST(Schematic, number_over_32_bits_is_an_error) {
  SchematicParts parts;
  parts.width = 1, parts.length = 1;
  parts.data = "\xff\xff\xff\xff\x7f";
  EXPECT_EQ(errorOf(parts), "the number ending at byte 5 of the block data does not fit 32 bits");
  parts.data = "\xff\xff\xff\xff\xff\xff\xff";
  EXPECT_EQ(errorOf(parts), "the number ending at byte 5 of the block data does not fit 32 bits");
  parts.data = "\x80";
  EXPECT_EQ(errorOf(parts), "the block data ends inside a number");
}

TEST(Schematic, block_data_must_fit_the_size_and_the_palette) {
  SchematicParts parts;
  parts.data = {"\0\1\1", 3};
  EXPECT_EQ(errorOf(parts), "\"BlockData\" holds 3 bytes: expected one a block at least, 4");
  parts.data = {"\x80\1\1\0\1", 5};
  EXPECT_EQ(errorOf(parts), "block (0, 0, 0) has palette index 128: expected 0 to 1");
  parts.data = {"\1\0\0\0\0", 5};
  EXPECT_EQ(errorOf(parts), "1 bytes follow the last of 4 blocks");
  parts.data = {"\x80\0\x80\0\0", 5};
  EXPECT_EQ(errorOf(parts), "the block data holds 3 of 4 blocks");
}

TEST(Schematic, palette_must_number_its_states_without_gaps) {
  SchematicParts parts;
  parts.palette = {{"minecraft:air", 0}, {"minecraft:stone", 2}};
  EXPECT_EQ(errorOf(parts), "the palette index of \"minecraft:stone\" is not in 0 to 1");
  parts.palette = {{"minecraft:air", 0}, {"minecraft:stone", 0}};
  EXPECT_EQ(errorOf(parts), "two block states have the palette index 0");
  parts.palette = {{"minecraft:air", 0}, {"Not A Block", 1}};
  EXPECT_EQ(errorOf(parts),
            "\"Not A Block\" in the palette is not a block state: "
            "expected name[property=value,...]");
}

TEST(Schematic, palettes_over_16_bits_are_errors) {
  SchematicParts parts;
  for (int i = 2; i < 65535; ++i) parts.palette.emplace_back("a:b" + std::to_string(i), i);
  EXPECT_EQ(errorOf(parts), "65535 block states: expected fewer than 65535");
}

TEST(Schematic, sizes_out_of_range_are_errors) {
  SchematicParts parts;
  parts.width = 0;
  EXPECT_EQ(errorOf(parts), "\"Width\" is 0: expected 1 to 512");
  parts.width = -1;  // an unsigned short
  EXPECT_EQ(errorOf(parts), "\"Width\" is 65535: expected 1 to 512");
  parts.width = parts.height = parts.length = 512;
  EXPECT_EQ(errorOf(parts),
            "\"BlockData\" holds 4 bytes: expected one a block at least, 134217728");
}

TEST(Schematic, what_is_no_schematic_says_so) {
  EXPECT_EQ(errorOf(""), "not a schematic: expected gzip data");
  EXPECT_EQ(errorOf("hello"), "not a schematic: expected gzip data");
  EXPECT_EQ(errorOf(gzip("hello")),
            "expected a compound tag (byte 10) (byte 0 of the decompressed data)");
  EXPECT_EQ(errorOf(gzip(nbtCompound("", ""))),
            "no integer \"Version\": expected a Sponge schematic");
  SchematicParts parts;
  parts.version = 0;
  EXPECT_EQ(errorOf(parts), "schematic version 0: expected 1, 2 or 3");
}

TEST(Schematic, damaged_and_truncated_gzip_are_distinguished) {
  const std::string file = SchematicParts().file();
  EXPECT_EQ(errorOf(file.substr(0, 40)),
            "the file is cut off: its compressed data ends after 40 bytes");
  std::string damaged = file;
  damaged[2] = 3;  // no such method of compression
  EXPECT_EQ(errorOf(damaged), "the compressed data is damaged");
}

TEST(Schematic, every_truncation_of_the_tags_is_an_error) {
  const std::string data = nbtCompound("Schematic", SchematicParts().members());
  for (std::size_t length = 0; length + 1 < data.size(); ++length) {
    EXPECT_NE(errorOf(gzip(data.substr(0, length))), "") << length;
  }
}

TEST(Schematic, nesting_is_limited) {
  std::string nested;
  for (int i = 0; i < 100; ++i) nested = nbtCompound("n", nested);
  EXPECT_EQ(errorOf(gzip(nbtCompound("", nested))).substr(0, 29),
            "\"n\" is nested deeper than 64 ");
}

TEST(Schematic, decompression_is_bounded) {
  const std::string bomb = gzip(std::string((std::size_t(1) << 28) + 1, '\0'));
  EXPECT_EQ(errorOf(bomb), "more than 67108864 bytes when decompressed");
}

TEST(Schematic, real_house_has_its_size_and_states) {
  const auto bytes = sharedSchematic();
  if (!bytes) GTEST_SKIP() << "shared/worlds/smallhouse1.schem is not here";
  Diagnostics diagnostics;
  const auto world = parseSchematic(*bytes, "smallhouse1.schem", diagnostics);
  ASSERT_TRUE(world) << joined(diagnostics);
  EXPECT_EQ(world->size(), glm::ivec3(21, 28, 20));
  EXPECT_EQ(world->palette().size(), 173u);
}

TEST(Schematic, truncations_of_a_real_house_are_errors) {
  const auto bytes = sharedSchematic();
  if (!bytes) GTEST_SKIP() << "shared/worlds/smallhouse1.schem is not here";
  for (std::size_t length = 0; length < bytes->size() - 8; length += 97) {
    EXPECT_NE(errorOf(bytes->substr(0, length)), "") << length;
  }
}

}  // namespace
}  // namespace orris
