// Writes map blocks and maps as Luanti does, for tests.
#pragma once

#include <sqlite3.h>
#include <zlib.h>
#include <zstd.h>

#include <filesystem>
#include <glm/glm.hpp>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "nbt_builder.h"

namespace orris {

inline std::string deflated(const std::string& bytes) {
  uLongf size = compressBound(uLong(bytes.size()));
  std::string packed(size, '\0');
  compress2(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
            uLong(bytes.size()), 6);
  packed.resize(size);
  return packed;
}
inline std::string zstdPacked(const std::string& bytes) {
  std::string packed(ZSTD_compressBound(bytes.size()), '\0');
  packed.resize(ZSTD_compress(packed.data(), packed.size(), bytes.data(), bytes.size(), 3));
  return packed;
}

struct MapBlockParts {
  std::vector<std::string> names = {"air"};
  std::vector<int> nodes = std::vector<int>(4096, 0), param2 = std::vector<int>(4096, 0);
  std::string metadata = std::string(1, '\0');
  int firstId = 100;  ///< of `names`

  void set(int x, int y, int z, const std::string& name, int turned = 0) {
    std::size_t i = 0;
    while (i < names.size() && names[i] != name) ++i;
    if (i == names.size()) names.push_back(name);
    nodes[std::size_t(z * 256 + y * 16 + x)] = int(i);
    param2[std::size_t(z * 256 + y * 16 + x)] = turned;
  }
  std::string nameList() const {
    std::string list = bigEndian(0, 1) + bigEndian(names.size(), 2);
    for (std::size_t i = 0; i < names.size(); ++i)
      list += bigEndian(i + std::size_t(firstId), 2) + bigEndian(names[i].size(), 2) + names[i];
    return list;
  }
  std::string nodeData(int version) const {
    std::string ids, light(4096, '\x0f'), turns;
    for (std::size_t i = 0; i < 4096; ++i) {
      const int id = nodes[i] + firstId;
      if (version >= 24)
        ids += bigEndian(std::uint64_t(id), 2);
      else  // 0x80 and above go on in param2
        ids += bigEndian(std::uint64_t(id < 0x80 ? id : id >> 4), 1);
      turns += bigEndian(std::uint64_t(version < 24 && id >= 0x80 ? (id & 15) << 4 | param2[i] : param2[i]), 1);
    }
    return ids + light + turns;
  }
  /// Everything of format 29 behind its number, before it is compressed.
  std::string body() const {
    return bigEndian(8, 1) + bigEndian(0xffff, 2) + bigEndian(77, 4) + nameList() + bigEndian(2, 1) + bigEndian(2, 1) +
           nodeData(29) + metadata + bigEndian(0, 1) + bigEndian(0, 2) + bigEndian(10, 1) + bigEndian(0, 2);
  }
  std::string bytes(int version) const {
    if (version == 29) return bigEndian(29, 1) + zstdPacked(body());
    const std::string timer(10, '\x01');
    std::string out = bigEndian(std::uint64_t(version), 1) + bigEndian(8, 1);
    if (version >= 27) out += bigEndian(0xffff, 2);
    out += bigEndian(version >= 24 ? 2 : 1, 1) + bigEndian(2, 1) + deflated(nodeData(version)) + deflated(metadata);
    if (version == 23) out += bigEndian(0, 1);
    if (version == 24) out += bigEndian(1, 1) + bigEndian(1, 2) + timer;
    // Two objects.
    out += bigEndian(0, 1) + bigEndian(2, 2);
    for (int i = 0; i < 2; ++i) out += std::string(13, '\x07') + bigEndian(5, 2) + "thing";
    out += bigEndian(77, 4) + nameList();
    if (version >= 25) out += bigEndian(10, 1) + bigEndian(1, 2) + timer;
    return out;
  }
};

inline void runSql(sqlite3* database, const std::string& text) {
  char* why = nullptr;
  if (sqlite3_exec(database, text.c_str(), nullptr, nullptr, &why) != SQLITE_OK) throw std::runtime_error(why);
}

enum class MapSchema { Number, Columns };

/// A map.sqlite; `sql` is run behind the rest.
inline void writeLuantiMap(const std::filesystem::path& file, MapSchema schema,
                           const std::vector<std::pair<glm::ivec3, std::string>>& blocks, const std::string& sql = "") {
  std::filesystem::remove(file);
  sqlite3* database = nullptr;
  sqlite3_open(file.c_str(), &database);
  const bool number = schema == MapSchema::Number;
  runSql(database, number ? "CREATE TABLE `blocks` (`pos` INT NOT NULL PRIMARY KEY, `data` BLOB)"
                          : "CREATE TABLE `blocks` (`x` INTEGER, `y` INTEGER, `z` INTEGER, `data` BLOB NOT NULL, "
                            "PRIMARY KEY (`x`, `z`, `y`))");
  runSql(database, "BEGIN");
  sqlite3_stmt* insert = nullptr;
  sqlite3_prepare_v2(database, number ? "INSERT INTO blocks VALUES (?1, ?4)" : "INSERT INTO blocks VALUES (?1, ?2, ?3, ?4)", -1,
                     &insert, nullptr);
  for (const auto& [at, bytes] : blocks) {
    sqlite3_reset(insert);
    if (number) {
      sqlite3_bind_int64(insert, 1, at.z * 0x1000000LL + at.y * 0x1000LL + at.x);
    } else {
      sqlite3_bind_int(insert, 1, at.x);
      sqlite3_bind_int(insert, 2, at.y);
      sqlite3_bind_int(insert, 3, at.z);
    }
    sqlite3_bind_blob(insert, 4, bytes.data(), int(bytes.size()), SQLITE_TRANSIENT);
    sqlite3_step(insert);
  }
  sqlite3_finalize(insert);
  runSql(database, "COMMIT");
  if (!sql.empty()) runSql(database, sql);
  sqlite3_close(database);
}

}  // namespace orris
