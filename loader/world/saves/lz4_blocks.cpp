#include <orris/world/saves/lz4_blocks.h>

#include <lz4.h>

#include <cstdint>

namespace orris {
namespace {

constexpr std::string_view kMagic = "LZ4Block";
// Magic, a byte of method and level, compressed and whole length, checksum; little endian.
constexpr std::size_t kHeader = 8 + 1 + 4 + 4 + 4;
constexpr std::uint32_t kLargestBlock = 32u << 20;  // net.jpountz: 64 bytes to 32 MiB
constexpr int kStored = 0x10, kCompressed = 0x20;

std::uint32_t littleEndian(std::string_view bytes) {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i-- > 0;) value = value << 8 | std::uint8_t(bytes[i]);
  return value;
}

bool unpackBlock(std::string_view data, int method, std::uint32_t whole, std::string& output) {
  if (method == kStored) {
    output += data;
    return data.size() == whole;
  }
  const std::size_t before = output.size();
  output.resize(before + whole);
  return method == kCompressed && LZ4_decompress_safe(data.data(), output.data() + before,
                                                      int(data.size()), int(whole)) == int(whole);
}

}  // namespace

GunzipResult unpackLz4Blocks(std::string_view input, std::size_t limit, std::string& output) {
  while (!input.empty()) {
    if (input.size() < kHeader) return GunzipResult::Truncated;
    if (!input.starts_with(kMagic)) return GunzipResult::Corrupt;
    const int method = std::uint8_t(input[8]) & 0xf0;
    const std::uint32_t packed = littleEndian(input.substr(9)),
                        whole = littleEndian(input.substr(13));
    input.remove_prefix(kHeader);
    if (whole == 0) return GunzipResult::Ok;
    if (packed > input.size()) return GunzipResult::Truncated;
    // LZ4 makes at most 255 bytes of one.
    if (whole > kLargestBlock || whole / 256 > packed) return GunzipResult::Corrupt;
    if (whole > limit - output.size()) return GunzipResult::TooLarge;
    if (!unpackBlock(input.substr(0, packed), method, whole, output)) return GunzipResult::Corrupt;
    input.remove_prefix(packed);
  }
  return GunzipResult::Ok;
}

}  // namespace orris
