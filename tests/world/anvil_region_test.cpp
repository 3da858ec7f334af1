#include <orris/world/saves/anvil_region.h>

#include <gtest/gtest.h>
#include <lz4.h>

#include <random>

#include "region_builder.h"
#include <orris/world/saves/anvil_chunk.h>
#include <orris/world/saves/lz4_blocks.h>

namespace orris {
namespace {

std::string problemAt(const std::string& file, glm::ivec2 chunk) {
  std::string problem;
  EXPECT_FALSE(AnvilRegion(file, {0, 0}).tags(chunk, nullptr, problem));
  return problem;
}

/// As the library of the game writes it: blocks, then one of no length.
std::string lz4Blocks(const std::string& data, int method) {
  const auto little = [](std::uint32_t value) {
    std::string text = bigEndian(value, 4);
    return std::string(text.rbegin(), text.rend());
  };
  std::string packed(std::size_t(LZ4_compressBound(int(data.size()))), '\0');
  packed.resize(std::size_t(
      LZ4_compress_default(data.data(), packed.data(), int(data.size()), int(packed.size()))));
  if (method == 0x10) packed = data;
  return "LZ4Block" + std::string(1, char(method | 6)) + little(std::uint32_t(packed.size())) +
         little(std::uint32_t(data.size())) + little(0) + packed + "LZ4Block" +
         std::string(1, char(0x10)) + little(0) + little(0) + little(0);
}

TEST(AnvilRegion, chunks_of_every_compression_are_read) {
  ChunkParts parts;
  parts.sections = {stoneFloor(0)};
  RegionParts region;
  region.chunks[{0, 0}] = {1, gzip(parts.tags())};
  region.chunks[{5, 0}] = {2, zlibbed(parts.tags())};
  region.chunks[{31, 31}] = {3, parts.tags()};
  region.chunks[{0, 7}] = {4, lz4Blocks(parts.tags(), 0x20)};
  region.chunks[{1, 7}] = {4, lz4Blocks(parts.tags(), 0x10)};
  const std::string file = region.file();
  const AnvilRegion reader(file, {0, 0});
  for (const auto& [place, chunk] : region.chunks) {
    std::string problem;
    const auto tags = reader.tags({place.first, place.second}, nullptr, problem);
    ASSERT_TRUE(tags) << chunk.first << ": " << problem;
    EXPECT_EQ(*tags, parts.tags());
  }
  EXPECT_TRUE(reader.holds({31, 31}));
  EXPECT_FALSE(reader.holds({30, 31}));
}

TEST(AnvilRegion, a_large_chunk_lies_in_a_file_of_its_own) {
  RegionParts region;
  region.chunks[{2, 3}] = {2 | 0x80, ""};
  const std::string file = region.file();
  const AnvilRegion reader(file, {-1, 2});
  std::string problem;
  const auto tags = reader.tags(
      {2, 3},
      [](glm::ivec2 chunk) {
        EXPECT_EQ(chunk, glm::ivec2(-30, 67));
        return std::optional(zlibbed("tags"));
      },
      problem);
  ASSERT_TRUE(tags) << problem;
  EXPECT_EQ(*tags, "tags");
  EXPECT_FALSE(reader.tags({2, 3}, nullptr, problem));
  EXPECT_EQ(problem, "it lies in c.-30.67.mcc, which cannot be read");
}

TEST(AnvilRegion, no_entry_of_the_table_is_believed) {
  RegionParts region;
  region.add(0, 0, "tags");
  const std::string file = region.file();
  EXPECT_EQ(problemAt("", {0, 0}), "the region ends inside its table of chunks");
  const auto changed = [&](std::size_t at, const std::string& bytes) {
    return std::string(file).replace(at, bytes.size(), bytes);
  };
  EXPECT_EQ(problemAt(changed(0, bigEndian(0x101, 4)), {0, 0}),
            "the table places it inside the table itself");
  EXPECT_EQ(problemAt(changed(0, bigEndian(0xffffff01, 4)), {0, 0}),
            "the table places it behind the end of the file");
  EXPECT_EQ(problemAt(changed(8192, bigEndian(5000, 4)), {0, 0}),
            "its length is 5000: expected 1 to 4092");
  EXPECT_EQ(problemAt(changed(8192, bigEndian(0, 4)), {0, 0}),
            "its length is 0: expected 1 to 4092");
  EXPECT_EQ(problemAt(changed(0, bigEndian(0x2ff, 4)).replace(8192, 4, bigEndian(9000, 4)), {0, 0}),
            "the file ends inside it");
  EXPECT_EQ(problemAt(changed(8196, "\x09"), {0, 0}),
            "its compression 9 is not known: expected 1 to 4");
  EXPECT_EQ(problemAt(changed(8197, "zzzz"), {0, 0}), "its compressed data is damaged");
}

TEST(AnvilRegion, decompression_is_bounded) {
  std::string problem;
  const std::string zeros(1 << 20, '\0');
  EXPECT_FALSE(decompressChunk(zlibbed(zeros), 2, 1000, problem));
  EXPECT_EQ(problem, "it is too large when decompressed");
  EXPECT_FALSE(decompressChunk(lz4Blocks(zeros, 0x20), 4, 1000, problem));
  EXPECT_EQ(problem, "it is too large when decompressed");
  EXPECT_FALSE(decompressChunk(zeros, 3, 1000, problem));
}

TEST(AnvilRegion, three_hundred_mutations_neither_crash_nor_hang) {
  ChunkParts parts;
  parts.sections = {stoneFloor(-4), stoneFloor(0), {1, {"minecraft:dirt"}, {}}};
  RegionParts region;
  region.add(0, 0, parts.tags());
  region.add(1, 0, parts.tags());
  region.chunks[{2, 0}] = {3, parts.tags()};
  region.chunks[{3, 0}] = {4, lz4Blocks(parts.tags(), 0x20)};
  const std::string file = region.file();
  std::mt19937 random(1);
  int read = 0, refused = 0;
  for (int i = 0; i < 300; ++i) {
    std::string damaged = file;
    for (int flip = 0; flip < 1 + i % 40; ++flip) {
      // A third of the flips in the table and the heads of chunks.
      const std::size_t at =
          random() % 3 == 0 ? random() % 16 : 8192 + random() % (damaged.size() - 8192);
      damaged[at] = char(damaged[at] ^ (1 << random() % 8));
    }
    if (i % 5 == 0) damaged.resize(random() % damaged.size());
    const AnvilRegion reader(damaged, {0, 0});
    for (int x = 0; x < 4; ++x) {
      std::string problem;
      const auto tags = reader.tags({x, 0}, nullptr, problem);
      AnvilChunk chunk;
      const bool good = tags && parseAnvilChunk(*tags, chunk, problem) != ChunkOutcome::Unreadable;
      EXPECT_TRUE(good || !problem.empty()) << i;
      ++(good ? read : refused);
    }
  }
  EXPECT_GT(read, 50);
  EXPECT_GT(refused, 300);
}

}  // namespace
}  // namespace orris
