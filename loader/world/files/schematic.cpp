#include <orris/world/files/schematic.h>

#include <fmt/core.h>

#include <vector>

#include <orris/core/add_diagnostic.h>
#include <orris/core/limits.h>
#include <orris/world/files/gunzip.h>
#include <orris/world/files/nbt.h>
#include <orris/world/files/tag_builds.h>

namespace orris {
namespace {

struct SchematicReader {
  const std::string& name;
  Diagnostics& diagnostics;
  std::int64_t maximumBlocks;

  bool fail(std::string message, std::string hint = "") {
    return addError(diagnostics, "schematic-invalid", {name}, std::move(message), std::move(hint));
  }

  bool decompress(std::string_view bytes, std::string& data) {
    const std::string_view gzipMagic("\x1f\x8b", 2);
    if (!bytes.starts_with(gzipMagic)) return fail("not a schematic: expected gzip data");
    switch (gunzip(bytes, limits::kSchematicBytes, data)) {
      case GunzipResult::Ok:
        return true;
      case GunzipResult::Truncated:
        return fail(fmt::format("the file is cut off: its compressed data ends after {} bytes",
                                bytes.size()),
                    "copy or download the file again");
      case GunzipResult::Corrupt:
        return fail("the compressed data is damaged");
      case GunzipResult::TooLarge:
        return fail(fmt::format("more than {} bytes when decompressed", limits::kSchematicBytes));
    }
    return false;
  }

  bool readVersion(const NbtTag& root, std::int64_t& version) {
    const NbtTag* tag = root.find("Version");
    if (!tag || !tag->integer()) {
      return fail("no integer \"Version\": expected a Sponge schematic",
                  "a .litematic has \"Regions\", a structure \"blocks\", a .schematic \"Blocks\"");
    }
    version = *tag->integer();
    if (version >= 1 && version <= 3) return true;
    return fail(fmt::format("schematic version {}: expected 1, 2 or 3", version));
  }

  bool readSize(const NbtTag& root, glm::ivec3& size) {
    const char* const names[] = {"Width", "Height", "Length"};
    std::int64_t blocks = 1;
    for (int axis = 0; axis < 3; ++axis) {
      const NbtTag* tag = root.find(names[axis]);
      if (!tag || !tag->integer()) return fail(fmt::format("no integer \"{}\"", names[axis]));
      const std::int64_t written = *tag->integer();
      const bool negativeShort = written < 0 && written >= -0x8000;  // an unsigned short
      const std::int64_t value = negativeShort ? written + 0x10000 : written;
      if (value < 1 || value > kMaxWorldSize) {
        return fail(
            fmt::format("\"{}\" is {}: expected 1 to {}", names[axis], value, kMaxWorldSize));
      }
      size[axis] = int(value);
      blocks *= value;
    }
    if (blocks <= maximumBlocks) return true;
    return fail(fmt::format("{} blocks: expected at most {}", blocks, maximumBlocks));
  }

  /// Entry i is the world's palette index of schematic index i.
  bool readPalette(const NbtTag* tag, BlockWorld& world, std::vector<std::uint32_t>& palette) {
    if (!tag || !tag->compound()) return fail("no compound \"Palette\"");
    const NbtCompound& entries = *tag->compound();
    if (entries.empty()) return fail("the palette is empty: expected a block state for each index");
    if (entries.size() >= kMaxPalette) {
      return fail(
          fmt::format("{} block states: expected fewer than {}", entries.size(), kMaxPalette));
    }
    palette.assign(entries.size(), 0);
    std::vector<bool> seen(entries.size());
    for (const auto& [text, index] : entries) {
      const std::optional<BlockState> state = parseBlockState(text);
      if (!state) {
        return fail(
            fmt::format("\"{}\" in the palette is not a block state: "
                        "expected name[property=value,...]",
                        text));
      }
      const std::int64_t* value = index.integer();
      if (!value || *value < 0 || *value >= std::int64_t(entries.size())) {
        return fail(
            fmt::format("the palette index of \"{}\" is not in 0 to {}", text, entries.size() - 1));
      }
      if (seen[std::size_t(*value)]) {
        return fail(fmt::format("two block states have the palette index {}", *value));
      }
      seen[std::size_t(*value)] = true;
      palette[std::size_t(*value)] = world.paletteIndex(*state);
    }
    return true;
  }

  bool readVarint(const std::string& data, std::size_t& position, std::uint32_t& value) {
    value = 0;
    for (int shift = 0; shift < 35; shift += 7) {
      if (position >= data.size()) return fail("the block data ends inside a number");
      const std::uint8_t byte = std::uint8_t(data[position++]);
      if (shift == 28 && byte > 0x0f) break;
      value |= std::uint32_t(byte & 0x7f) << shift;
      if (!(byte & 0x80)) return true;
    }
    return fail(fmt::format("the number ending at byte {} of the block data does not fit 32 bits",
                            position));
  }

  bool readBlocks(const std::string& data, const std::vector<std::uint32_t>& palette,
                  BlockWorld& world) {
    const glm::ivec3 size = world.size();
    std::size_t position = 0, block = 0;
    const std::size_t total = std::size_t(size.x) * size.y * size.z;
    for (int y = 0; y < size.y; ++y) {
      for (int z = 0; z < size.z; ++z) {
        for (int x = 0; x < size.x; ++x, ++block) {
          if (position >= data.size()) {
            return fail(fmt::format("the block data holds {} of {} blocks", block, total));
          }
          std::uint32_t index = 0;
          if (!readVarint(data, position, index)) return false;
          if (index >= palette.size()) {
            return fail(fmt::format("block ({}, {}, {}) has palette index {}: expected 0 to {}", x,
                                    y, z, index, palette.size() - 1));
          }
          world.set({x, y, z}, palette[index]);
        }
      }
    }
    if (position == data.size()) return true;
    return fail(
        fmt::format("{} bytes follow the last of {} blocks", data.size() - position, total));
  }

  /// Every block takes a byte at least, so that a small file cannot ask for a large world.
  const std::string* findData(const NbtTag& parent, const char* key, glm::ivec3 size) {
    const NbtTag* tag = parent.find(key);
    const NbtBytes* data = tag ? tag->bytes() : nullptr;
    const std::size_t total = std::size_t(size.x) * size.y * size.z;
    if (!data) {
      fail(fmt::format("no byte array \"{}\"", key));
    } else if (data->bytes.size() < total) {
      fail(fmt::format("\"{}\" holds {} bytes: expected one a block at least, {}", key,
                       data->bytes.size(), total));
    } else {
      return &data->bytes;
    }
    return nullptr;
  }

  std::optional<BlockWorld> read(const NbtTag& file) {
    if (const BuildFormat format = buildFormatOf(file); format != BuildFormat::Sponge) {
      std::string problem;
      auto world = readBuild(file, format, maximumBlocks, problem);
      if (!world) fail(std::move(problem));
      return world;
    }
    // Version 3 wraps everything in a member and moves the blocks into another.
    const NbtTag* wrapped = file.find("Schematic");
    const NbtTag& root = wrapped ? *wrapped : file;
    std::int64_t version = 0;
    glm::ivec3 size{0};
    if (!readVersion(root, version) || !readSize(root, size)) return std::nullopt;
    const NbtTag* blocks = version == 3 ? root.find("Blocks") : &root;
    if (!blocks) {
      fail("no compound \"Blocks\"");
      return std::nullopt;
    }
    const std::string* data = findData(*blocks, version == 3 ? "Data" : "BlockData", size);
    if (!data) return std::nullopt;
    BlockWorld world(glm::ivec3(0), size);
    std::vector<std::uint32_t> palette;
    if (!readPalette(blocks->find("Palette"), world, palette)) return std::nullopt;
    if (!readBlocks(*data, palette, world)) return std::nullopt;
    return world;
  }
};

}  // namespace

std::optional<BlockWorld> parseSchematicTags(std::string_view tags, const std::string& name,
                                             Diagnostics& diagnostics, std::int64_t maximumBlocks) {
  SchematicReader reader{name, diagnostics, maximumBlocks};
  NbtError error;
  const std::optional<NbtTag> root = parseNbt(tags, error);
  if (!root) {
    reader.fail(fmt::format("{} (byte {} of the decompressed data)", error.message, error.offset));
    return std::nullopt;
  }
  return reader.read(*root);
}

std::optional<BlockWorld> parseSchematic(std::string_view bytes, const std::string& name,
                                         Diagnostics& diagnostics, std::int64_t maximumBlocks) {
  std::string tags;
  if (!SchematicReader{name, diagnostics, maximumBlocks}.decompress(bytes, tags)) {
    return std::nullopt;
  }
  return parseSchematicTags(tags, name, diagnostics, maximumBlocks);
}

}  // namespace orris
