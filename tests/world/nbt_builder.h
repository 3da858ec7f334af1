// Writes NBT and gzip, for schematics made by tests.
#pragma once

#include <zlib.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace orris {

inline std::string bigEndian(std::uint64_t value, int bytes) {
  std::string text;
  for (int shift = 8 * (bytes - 1); shift >= 0; shift -= 8) text += char(value >> shift & 0xff);
  return text;
}

inline std::string nbtTag(char type, const std::string& name, const std::string& payload) {
  return std::string(1, type) + bigEndian(name.size(), 2) + name + payload;
}
inline std::string nbtShort(const std::string& name, int value) {
  return nbtTag(2, name, bigEndian(std::uint64_t(value), 2));
}
inline std::string nbtInt(const std::string& name, int value) {
  return nbtTag(3, name, bigEndian(std::uint64_t(value), 4));
}
inline std::string nbtByteArray(const std::string& name, const std::string& bytes) {
  return nbtTag(7, name, bigEndian(bytes.size(), 4) + bytes);
}
inline std::string nbtCompound(const std::string& name, const std::string& members) {
  return nbtTag(10, name, members + std::string(1, '\0'));
}

inline std::string gzip(const std::string& data) {
  z_stream stream{};
  deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY);
  std::string output(deflateBound(&stream, data.size()) + 64, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(data.data()));
  stream.avail_in = uInt(data.size());
  stream.next_out = reinterpret_cast<Bytef*>(output.data());
  stream.avail_out = uInt(output.size());
  deflate(&stream, Z_FINISH);
  output.resize(stream.total_out);
  deflateEnd(&stream);
  return output;
}

/// The parts of a version 2 schematic; tests change one at a time.
struct SchematicParts {
  int version = 2, width = 2, height = 1, length = 2;
  std::vector<std::pair<std::string, int>> palette = {{"minecraft:air", 0}, {"minecraft:stone", 1}};
  std::string data{"\0\1\1\0", 4};

  std::string members() const {
    std::string entries;
    for (const auto& [name, index] : palette) entries += nbtInt(name, index);
    const std::string size =
        nbtShort("Width", width) + nbtShort("Height", height) + nbtShort("Length", length);
    if (version < 3) {
      return nbtInt("Version", version) + size + nbtCompound("Palette", entries) +
             nbtByteArray("BlockData", data);
    }
    const std::string blocks = nbtCompound("Palette", entries) + nbtByteArray("Data", data);
    return nbtCompound("Schematic",
                       nbtInt("Version", version) + size + nbtCompound("Blocks", blocks));
  }
  std::string file() const { return gzip(nbtCompound(version < 3 ? "Schematic" : "", members())); }
};

}  // namespace orris
