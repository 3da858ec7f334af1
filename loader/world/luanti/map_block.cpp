#include <orris/world/luanti/map_block.h>

#include <fmt/core.h>

#include <orris/core/limits.h>
#include <orris/world/blocks/block_world.h>
#include <orris/world/files/unzstd.h>

namespace orris {
namespace {

constexpr int kOldestFormat = 22, kNewestFormat = 29;
constexpr int kWideContent = 24;     // before, a node's number has 8 or 12 bits
constexpr int kTimersBehind = 25;    // before, timers stand in front of the objects
constexpr int kLightComplete = 27;
constexpr std::size_t kTimerBytes = 2 + 4 + 4, kObjectBytes = 1 + 3 * 4;

/// Numbers and texts from the front; nothing behind the end, which `ended` says.
class FrontReader {
 public:
  explicit FrontReader(std::string_view bytes) : bytes_(bytes) {}

  std::string_view text(std::size_t size) {
    if (size > bytes_.size()) {
      ended_ = true;
      bytes_ = {};
      return {};
    }
    const std::string_view found = bytes_.substr(0, size);
    bytes_.remove_prefix(size);
    return found;
  }
  std::size_t number(std::size_t size) {
    std::size_t value = 0;
    for (const char byte : text(size)) value = value << 8 | std::uint8_t(byte);
    return value;
  }
  std::string_view rest() const { return bytes_; }
  bool ended() const { return ended_; }

 private:
  std::string_view bytes_;
  bool ended_ = false;
};

struct MapBlockReader {
  MapBlock block;
  std::string& problem;
  std::size_t size = 0;
  int version = 0;
  std::vector<std::uint32_t> indexOfId;  ///< 1 more than the index of its name; 0: it has none

  bool fail(std::string why) {
    problem = std::move(why);
    return false;
  }

  bool decompressed(GunzipResult result, const std::string& bytes, const char* what) {
    size += bytes.size();
    if (result == GunzipResult::Ok) return true;
    const char* why = result == GunzipResult::Truncated  ? "cut off"
                      : result == GunzipResult::TooLarge ? "too large when decompressed"
                                                         : "damaged";
    return fail(fmt::format("its {} is {}", what, why));
  }

  bool readNames(FrontReader& reader) {
    if (const std::size_t format = reader.number(1); format != 0 && !reader.ended())
      return fail(fmt::format("its list of names has format {}: expected 0", format));
    const std::size_t count = reader.number(2);
    for (std::size_t i = 0; i < count && !reader.ended(); ++i) {
      const std::size_t id = reader.number(2);
      const std::size_t length = reader.number(2);
      block.names.emplace_back(reader.text(length));
      if (indexOfId.size() <= id) indexOfId.resize(id + 1);
      indexOfId[id] = std::uint32_t(block.names.size());
    }
    return !reader.ended() || fail("it ends inside its list of names");
  }

  bool readWidths(FrontReader& reader) {
    const std::size_t content = reader.number(1), params = reader.number(1);
    const std::size_t expected = version < kWideContent ? 1 : 2;
    if (reader.ended()) return fail("it ends before its nodes");
    return (content == expected && params == 2) ||
           fail(fmt::format("its nodes have {} and {} bytes: expected {} and 2", content, params, expected));
  }

  std::size_t bytesOfNodes() const { return kSectionBlocks * (version < kWideContent ? 3 : 4); }

  bool readNodes(std::string_view bytes) {
    if (bytes.size() < bytesOfNodes())
      return fail(fmt::format("its nodes have {} bytes: expected {}", bytes.size(), bytesOfNodes()));
    const std::size_t wide = version < kWideContent ? 1 : 2;
    block.param2 = bytes.substr(kSectionBlocks * (wide + 1), kSectionBlocks);
    block.nodes.resize(kSectionBlocks);
    for (std::size_t i = 0; i < kSectionBlocks; ++i) {
      std::size_t id = std::uint8_t(bytes[i * wide]);
      if (wide == 2)
        id = id << 8 | std::uint8_t(bytes[i * wide + 1]);
      else if (id >= 0x80)
        id = id << 4 | std::uint8_t(block.param2[i]) >> 4;
      if (id >= indexOfId.size() || indexOfId[id] == 0)
        return fail(fmt::format("a node has the number {}, which its list of names lacks", id));
      block.nodes[i] = std::uint16_t(indexOfId[id] - 1);
    }
    return true;
  }

  /// Format 29: all of it is one frame, with the names in front.
  bool readFrame(std::string_view bytes) {
    std::string body;
    if (!decompressed(unzstd(bytes, limits::kChunkBytes, body), body, "compressed data")) return false;
    FrontReader reader(body);
    reader.text(1 + 2 + 4);  // flags, light, time
    return readNames(reader) && readWidths(reader) && readNodes(reader.text(bytesOfNodes()));
  }

  void skipTimersBeforeObjects(FrontReader& reader) {
    if (version >= kTimersBehind || version < kWideContent - 1) return;
    const std::size_t format = reader.number(1);
    if (version == kWideContent && format == 1) reader.text(reader.number(2) * kTimerBytes);
  }

  void skipObjects(FrontReader& reader) {
    reader.number(1);
    const std::size_t count = reader.number(2);
    for (std::size_t i = 0; i < count && !reader.ended(); ++i) {
      reader.text(kObjectBytes);
      reader.text(reader.number(2));
    }
  }

  /// Formats 22 to 28: nodes and metadata are streams, and the names stand behind them.
  bool readStreams(std::string_view bytes) {
    FrontReader reader(bytes);
    reader.text(version >= kLightComplete ? 1 + 2 : 1);  // flags, light
    if (!readWidths(reader)) return false;
    std::string nodes;
    std::size_t used = 0;
    if (!decompressed(gunzip(reader.rest(), bytesOfNodes(), nodes, &used), nodes, "stream of nodes"))
      return false;
    reader.text(used);
    std::string metadata;
    if (!decompressed(gunzip(reader.rest(), limits::kChunkBytes, metadata, &used), metadata,
                      "stream of metadata"))
      return false;
    reader.text(used);
    skipTimersBeforeObjects(reader);
    skipObjects(reader);
    reader.text(4);  // time
    return readNames(reader) && readNodes(nodes);
  }

  bool read(std::string_view bytes) {
    if (bytes.empty()) return fail("it is empty");
    version = std::uint8_t(bytes.front());
    if (version < kOldestFormat || version > kNewestFormat)
      return fail(fmt::format("its format is {}: expected {} to {}", version, kOldestFormat, kNewestFormat));
    bytes.remove_prefix(1);
    return version == kNewestFormat ? readFrame(bytes) : readStreams(bytes);
  }
};

}  // namespace

std::optional<MapBlock> parseMapBlock(std::string_view bytes, std::string& problem, std::size_t& size) {
  MapBlockReader reader{.block = {}, .problem = problem, .indexOfId = {}};
  const bool read = reader.read(bytes);
  size = reader.size;
  if (!read) return std::nullopt;
  return std::move(reader.block);
}

}  // namespace orris
