// A map block of Luanti. So that mutations reach what is compressed, the target compresses it: behind the format 29 all of the rest,
// behind an older one its two streams, each with its length in two bytes in front. Behind 0x80 the bytes are taken as they are.
#include <zlib.h>
#include <zstd.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include <orris/world/luanti/map_block.h>
#include <orris/world/luanti/node_blocks.h>

namespace {

std::string frameOf(std::string_view body) {
  std::string packed(ZSTD_compressBound(body.size()), '\0');
  packed.resize(ZSTD_compress(packed.data(), packed.size(), body.data(), body.size(), -5));
  return packed;
}

std::string streamOf(std::string_view body) {
  uLongf size = compressBound(uLong(body.size()));
  std::string packed(size, '\0');
  compress2(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(body.data()), uLong(body.size()), 1);
  packed.resize(size);
  return packed;
}

std::string_view front(std::string_view& bytes, std::size_t size) {
  const std::string_view taken = bytes.substr(0, size);
  bytes.remove_prefix(taken.size());
  return taken;
}

std::string_view sized(std::string_view& bytes) {
  std::size_t size = 0;
  for (const char byte : front(bytes, 2)) size = size << 8 | std::uint8_t(byte);
  return front(bytes, size);
}

std::string blockOf(std::string_view bytes) {
  std::string made(front(bytes, 1));
  const int version = made.empty() ? 0 : std::uint8_t(made[0]);
  if (version == 0x80) return std::string(bytes);
  if (version == 29) return made + frameOf(bytes);
  made += front(bytes, version >= 27 ? 5 : 3);
  made += streamOf(sized(bytes));
  made += streamOf(sized(bytes));
  return made.append(bytes);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string problem;
  std::size_t decompressed = 0;
  const auto block = orris::parseMapBlock(blockOf({reinterpret_cast<const char*>(data), size}), problem, decompressed);
  if (!block) {
    if (problem.empty()) std::abort();
    return 0;
  }
  if (block->nodes.size() != 4096 || block->param2.size() != 4096) std::abort();
  for (std::size_t i = 0; i < block->nodes.size(); ++i) {
    if (block->nodes[i] >= block->names.size()) std::abort();
    if (i % 64 == 0) orris::blockOfNode(block->names[block->nodes[i]], std::uint8_t(block->param2[i]));
  }
  return 0;
}
