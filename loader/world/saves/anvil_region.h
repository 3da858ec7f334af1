// Region files (r.X.Z.mca): a table of 32x32 chunks and their compressed tags.
#pragma once

#include <cstddef>
#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace orris {

constexpr int kRegionChunks = 32;  ///< along each side of a region

/// The bytes of c.X.Z.mcc, where the game puts a chunk too large for its region; nullopt when they
/// cannot be read. `chunk` is the world's.
using ExternalChunkReader = std::function<std::optional<std::string>(glm::ivec2 chunk)>;

/// Chunks are named by their place in the region, 0..31 each. No entry of the table is believed.
class AnvilRegion {
 public:
  /// `bytes` outlive the region; `place` is that of the region, in regions.
  AnvilRegion(std::string_view bytes, glm::ivec2 place) : bytes_(bytes), place_(place) {}

  /// Does the table name a place for the chunk?
  bool holds(glm::ivec2 chunk) const { return sectors(chunk) > 0; }
  /// Sectors of 4096 bytes that the table gives it: a finished chunk has more than one begun.
  int sectors(glm::ivec2 chunk) const;
  /// The chunk's tags, decompressed; nullopt and why not.
  std::optional<std::string> tags(glm::ivec2 chunk, const ExternalChunkReader& external,
                                  std::string& problem) const;

 private:
  std::string_view bytes_;
  glm::ivec2 place_;
};

/// What follows a chunk's length: gzip (1), zlib (2), nothing (3) or LZ4 (4). At most `limit` bytes.
std::optional<std::string> decompressChunk(std::string_view data, int method, std::size_t limit,
                                           std::string& problem);

}  // namespace orris
