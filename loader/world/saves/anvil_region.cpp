#include <orris/world/saves/anvil_region.h>

#include <fmt/core.h>

#include <cstdint>

#include <orris/core/limits.h>
#include <orris/world/files/gunzip.h>
#include <orris/world/saves/lz4_blocks.h>

namespace orris {
namespace {

constexpr std::size_t kSector = 4096;
constexpr std::size_t kTables = 2 * kSector;  // places, then times
constexpr int kExternal = 0x80;               // of the byte that names the compression

enum Compression { Gzip = 1, Zlib = 2, Plain = 3, Lz4 = 4 };

std::uint32_t bigEndian(std::string_view bytes, std::size_t count) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < count; ++i) value = value << 8 | std::uint8_t(bytes[i]);
  return value;
}

const char* whyNot(GunzipResult result) {
  switch (result) {
    case GunzipResult::Truncated:
      return "its compressed data is cut off";
    case GunzipResult::TooLarge:
      return "it is too large when decompressed";
    default:
      return "its compressed data is damaged";
  }
}

std::optional<std::string> refused(std::string& problem, std::string why) {
  problem = std::move(why);
  return std::nullopt;
}

}  // namespace

std::optional<std::string> decompressChunk(std::string_view data, int method, std::size_t limit,
                                           std::string& problem) {
  std::string tags;
  GunzipResult result = GunzipResult::Ok;
  switch (method) {
    case Gzip:
    case Zlib:
      result = gunzip(data, limit, tags);
      break;
    case Plain:
      if (data.size() > limit) return refused(problem, whyNot(GunzipResult::TooLarge));
      tags = data;
      break;
    case Lz4:
      result = unpackLz4Blocks(data, limit, tags);
      break;
    default:
      return refused(problem,
                     fmt::format("its compression {} is not known: expected 1 to 4", method));
  }
  if (result != GunzipResult::Ok) return refused(problem, whyNot(result));
  return tags;
}

int AnvilRegion::sectors(glm::ivec2 chunk) const {
  const auto entry = std::size_t(chunk.y * kRegionChunks + chunk.x) * 4;
  if (bytes_.size() < entry + 4) return 0;
  const std::uint32_t place = bigEndian(bytes_.substr(entry), 4);
  return place == 0 ? 0 : std::max(1, int(place & 0xff));
}

std::optional<std::string> AnvilRegion::tags(glm::ivec2 chunk, const ExternalChunkReader& external,
                                             std::string& problem) const {
  const auto entry = std::size_t(chunk.y * kRegionChunks + chunk.x) * 4;
  if (bytes_.size() < kTables)
    return refused(problem, "the region ends inside its table of chunks");
  const std::size_t start = std::size_t(bigEndian(bytes_.substr(entry), 3)) * kSector;
  const std::size_t room = std::size_t(std::uint8_t(bytes_[entry + 3])) * kSector;
  if (start < kTables) return refused(problem, "the table places it inside the table itself");
  if (start + 5 > bytes_.size())
    return refused(problem, "the table places it behind the end of the file");
  const std::size_t length = bigEndian(bytes_.substr(start), 4);
  // The table's room is a byte of sectors; a chunk that needs more is in a file of its own.
  if (length < 1 || length + 4 > room) {
    return refused(problem, fmt::format("its length is {}: expected 1 to {}", length,
                                        room - std::min<std::size_t>(room, 4)));
  }
  if (length + 4 > bytes_.size() - start) return refused(problem, "the file ends inside it");
  const int method = std::uint8_t(bytes_[start + 4]);
  if ((method & kExternal) == 0)
    return decompressChunk(bytes_.substr(start + 5, length - 1), method, limits::kChunkBytes,
                           problem);
  const glm::ivec2 inWorld = place_ * kRegionChunks + chunk;
  const auto file = external ? external(inWorld) : std::nullopt;
  if (!file)
    return refused(
        problem, fmt::format("it lies in c.{}.{}.mcc, which cannot be read", inWorld.x, inWorld.y));
  return decompressChunk(*file, method & ~kExternal, limits::kChunkBytes, problem);
}

}  // namespace orris
