#include <orris/world/luanti/map_block.h>

#include <gtest/gtest.h>

#include <orris/core/limits.h>

#include "luanti_builder.h"

namespace orris {
namespace {

std::string mapBlockProblem(const std::string& bytes) {
  std::string problem;
  std::size_t size = 0;
  return parseMapBlock(bytes, problem, size) ? "" : problem;
}

std::string joinedStreams(const std::string& nodes, const std::string& metadata, const std::string& behind) {
  return std::string("\x1c\x00\xff\xff\x02\x02", 6) + deflated(nodes) + deflated(metadata) + behind;
}

TEST(MapBlocks, names_nodes_and_param2) {
  MapBlockParts parts;
  parts.set(1, 2, 3, "default:stone", 17);
  for (const int version : {28, 29}) {
    std::string problem;
    std::size_t size = 0;
    const auto block = parseMapBlock(parts.bytes(version), problem, size);
    ASSERT_TRUE(block) << problem;
    EXPECT_EQ(block->names, (std::vector<std::string>{"air", "default:stone"}));
    EXPECT_EQ(block->nodes[3 * 256 + 2 * 16 + 1], 1);
    EXPECT_EQ(block->param2[3 * 256 + 2 * 16 + 1], 17);
    EXPECT_EQ(block->nodes[0], 0);
    EXPECT_GT(size, 16384u);
  }
}

TEST(MapBlocks, cut_anywhere_they_are_refused) {
  MapBlockParts parts;
  parts.set(1, 2, 3, "default:stone");
  for (const int version : {22, 24, 28, 29}) {
    const std::string whole = parts.bytes(version);
    // Timers at the end are not read.
    for (std::size_t size = 0; size + 13 < whole.size(); ++size)
      EXPECT_NE(mapBlockProblem(whole.substr(0, size)), "") << version << ' ' << size;
  }
  const std::string body = parts.body();
  const std::size_t needed = body.size() - 1 - 6;  // metadata, objects, timers
  for (std::size_t size = 0; size < body.size(); size += size < 40 ? 1 : 97)
    EXPECT_EQ(mapBlockProblem("\x1d" + zstdPacked(body.substr(0, size))) == "", size >= needed) << size;
}

TEST(MapBlocks, bombs_are_refused) {
  const std::string nodes = MapBlockParts().nodeData(28), names = MapBlockParts().nameList();
  const std::string zeros(limits::kChunkBytes + 1, '\0');
  const std::string behind = bigEndian(0, 1) + bigEndian(0, 2) + bigEndian(0, 4) + names;
  EXPECT_EQ(mapBlockProblem(joinedStreams(nodes, "", behind)), "");
  EXPECT_EQ(mapBlockProblem(joinedStreams(nodes, zeros, behind)), "its stream of metadata is too large when decompressed");
  EXPECT_EQ(mapBlockProblem(joinedStreams(nodes + "x", "", behind)), "its stream of nodes is too large when decompressed");
  EXPECT_EQ(mapBlockProblem("\x1d" + zstdPacked(zeros)), "its compressed data is too large when decompressed");
}

TEST(MapBlocks, windows_beyond_the_limit_are_refused) {
  ZSTD_CCtx* context = ZSTD_createCCtx();
  ZSTD_CCtx_setParameter(context, ZSTD_c_windowLog, 25);
  ZSTD_CCtx_setParameter(context, ZSTD_c_contentSizeFlag, 0);
  const std::string body = MapBlockParts().body();
  std::string packed(ZSTD_compressBound(body.size()), '\0');
  ZSTD_inBuffer in{body.data(), body.size(), 0};
  ZSTD_outBuffer out{packed.data(), packed.size(), 0};
  // In two steps, so that the size is not known in front.
  ZSTD_compressStream2(context, &out, &in, ZSTD_e_flush);
  ZSTD_compressStream2(context, &out, &in, ZSTD_e_end);
  ZSTD_freeCCtx(context);
  EXPECT_EQ(mapBlockProblem("\x1d" + packed.substr(0, out.pos)), "its compressed data is damaged");
}

TEST(MapBlocks, numbers_without_a_name_are_refused) {
  MapBlockParts parts;
  parts.nodes[7] = 60000;
  EXPECT_EQ(mapBlockProblem(parts.bytes(29)), "a node has the number 60100, which its list of names lacks");
  parts.nodes[7] = -1;
  EXPECT_EQ(mapBlockProblem(parts.bytes(28)), "a node has the number 99, which its list of names lacks");
}

TEST(MapBlocks, widths_and_lists_of_other_formats_are_refused) {
  std::string body = MapBlockParts().body();
  EXPECT_EQ(mapBlockProblem("\x1e" + zstdPacked(body)), "its format is 30: expected 22 to 29");
  std::string other = body;
  other[7] = 1;
  EXPECT_EQ(mapBlockProblem("\x1d" + zstdPacked(other)), "its list of names has format 1: expected 0");
  other = body;
  other[7 + 3 + 4 + 3] = 1;
  EXPECT_EQ(mapBlockProblem("\x1d" + zstdPacked(other)), "its nodes have 1 and 2 bytes: expected 2 and 2");
  EXPECT_EQ(mapBlockProblem(""), "it is empty");
}

}  // namespace
}  // namespace orris
