// Writes chunks, regions and saves as the game does, for tests.
#pragma once

#include <bit>
#include <filesystem>
#include <fstream>
#include <map>
#include <utility>

#include "nbt_builder.h"

namespace orris {

inline std::string nbtByte(const std::string& name, int value) {
  return nbtTag(1, name, bigEndian(std::uint64_t(value), 1));
}
inline std::string nbtLong(const std::string& name, std::int64_t value) {
  return nbtTag(4, name, bigEndian(std::uint64_t(value), 8));
}
inline std::string nbtString(const std::string& name, const std::string& text) {
  return nbtTag(8, name, bigEndian(text.size(), 2) + text);
}
inline std::string nbtLongs(const std::string& name, const std::vector<std::uint64_t>& numbers) {
  std::string payload = bigEndian(numbers.size(), 4);
  for (const std::uint64_t number : numbers) payload += bigEndian(number, 8);
  return nbtTag(12, name, payload);
}
/// Items are payloads: of compounds (10) their members and a closing byte 0.
inline std::string nbtList(const std::string& name, char type,
                           const std::vector<std::string>& items) {
  std::string payload = std::string(1, items.empty() ? '\0' : type) + bigEndian(items.size(), 4);
  for (const std::string& item : items) payload += item;
  return nbtTag(9, name, payload);
}
/// Where things stand, as the game writes it.
inline std::string nbtDoubles(const std::string& name, const std::vector<double>& values) {
  std::vector<std::string> items;
  for (const double value : values)
    items.push_back(bigEndian(std::bit_cast<std::uint64_t>(value), 8));
  return nbtList(name, 6, items);
}
inline std::string nbtFloats(const std::string& name, const std::vector<float>& values) {
  std::vector<std::string> items;
  for (const float value : values)
    items.push_back(bigEndian(std::bit_cast<std::uint32_t>(value), 4));
  return nbtList(name, 5, items);
}
inline std::string closed(const std::string& members) { return members + std::string(1, '\0'); }

/// Bit by bit, so that it shares nothing with the reader.
inline std::vector<std::uint64_t> packIndices(const std::vector<int>& indices, int bits,
                                              bool across) {
  std::vector<std::uint64_t> numbers;
  std::size_t position = 0;
  for (const int index : indices) {
    if (!across && position % 64 + std::size_t(bits) > 64) position += 64 - position % 64;
    for (int bit = 0; bit < bits; ++bit, ++position) {
      if (position / 64 >= numbers.size()) numbers.push_back(0);
      if (index >> bit & 1) numbers[position / 64] |= std::uint64_t(1) << position % 64;
    }
  }
  return numbers;
}

inline std::string zlibbed(const std::string& data) {
  uLongf size = compressBound(data.size());
  std::string output(size, '\0');
  compress(reinterpret_cast<Bytef*>(output.data()), &size,
           reinterpret_cast<const Bytef*>(data.data()), data.size());
  output.resize(size);
  return output;
}

enum class ChunkFormat { Across, Level116, Flat };  ///< 1.13 to 1.15, 1.16 and 1.17, 1.18 and later

struct SectionParts {
  int y = 0;
  std::vector<std::string> palette = {"minecraft:air", "minecraft:stone"};
  std::vector<int> indices = {};  ///< 4096, or empty for none
};

inline int bitsFor(std::size_t states) {
  int bits = 4;
  while ((std::size_t(1) << bits) < states) ++bits;
  return bits;
}

/// "minecraft:oak_log[axis=x]" as a compound's payload.
inline std::string paletteEntry(const std::string& state) {
  const std::size_t bracket = state.find('[');
  std::string members = nbtString("Name", state.substr(0, bracket));
  std::string properties;
  for (std::size_t at = bracket; at != std::string::npos && state[at] != ']';) {
    const std::size_t equals = state.find('=', at), end = state.find_first_of(",]", equals);
    properties += nbtString(state.substr(at + 1, equals - at - 1),
                            state.substr(equals + 1, end - equals - 1));
    at = end;
  }
  if (!properties.empty()) members += nbtCompound("Properties", properties);
  return closed(members);
}

/// A chunk's tags; tests change one part at a time.
struct ChunkParts {
  ChunkFormat format = ChunkFormat::Flat;
  std::string status = "minecraft:full";
  std::string biome = "minecraft:desert";
  std::vector<SectionParts> sections;
  std::vector<std::string> entities = {}, blockEntities = {};  ///< payloads of compounds

  std::string section(const SectionParts& parts) const {
    std::vector<std::string> entries;
    for (const std::string& state : parts.palette) entries.push_back(paletteEntry(state));
    const std::vector<std::uint64_t> numbers =
        packIndices(parts.indices, bitsFor(parts.palette.size()), format == ChunkFormat::Across);
    std::string members = nbtByte("Y", parts.y);
    if (format == ChunkFormat::Flat) {
      std::string states = nbtList("palette", 10, entries);
      if (!numbers.empty()) states += nbtLongs("data", numbers);
      members += nbtCompound("block_states", states);
      members += nbtCompound("biomes", nbtList("palette", 8, {bigEndian(biome.size(), 2) + biome}));
    } else if (!parts.palette.empty()) {
      members += nbtList("Palette", 10, entries) + nbtLongs("BlockStates", numbers);
    }
    return closed(members);
  }

  std::string tags() const {
    std::vector<std::string> items;
    for (const SectionParts& parts : sections) items.push_back(section(parts));
    const bool flat = format == ChunkFormat::Flat;
    std::string body =
        nbtString("Status", status) + nbtList(flat ? "sections" : "Sections", 10, items);
    if (!entities.empty()) body += nbtList("Entities", 10, entities);
    if (!blockEntities.empty())
      body += nbtList(flat ? "block_entities" : "TileEntities", 10, blockEntities);
    return nbtCompound(
        "", nbtInt("DataVersion", flat ? 3465 : 2230) + (flat ? body : nbtCompound("Level", body)));
  }
};

/// A region file of chunks by place x, z in it, each with its compression and compressed bytes.
struct RegionParts {
  std::map<std::pair<int, int>, std::pair<int, std::string>> chunks;

  void add(int x, int z, const std::string& tags) { chunks[{x, z}] = {2, zlibbed(tags)}; }
  std::string file() const {
    std::string table(8192, '\0'), body;
    for (const auto& [place, chunk] : chunks) {
      std::string bytes = bigEndian(chunk.second.size() + 1, 4) + char(chunk.first) + chunk.second;
      bytes.resize((bytes.size() + 4095) / 4096 * 4096);
      const std::uint64_t entry = (2 + body.size() / 4096) << 8 | bytes.size() / 4096;
      table.replace(std::size_t(place.second * 32 + place.first) * 4, 4, bigEndian(entry, 4));
      body += bytes;
    }
    return table + body;
  }
};

/// A floor of stone over the lowest layer of section y.
inline SectionParts stoneFloor(int y) {
  SectionParts parts{y};
  parts.indices.assign(4096, 0);
  std::fill_n(parts.indices.begin(), 256, 1);
  return parts;
}

}  // namespace orris
