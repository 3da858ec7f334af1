// Named binary tags, the format of the game's saved data (uncompressed, big endian).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace orris {

struct NbtTag;
using NbtList = std::vector<NbtTag>;
using NbtCompound = std::vector<std::pair<std::string, NbtTag>>;  ///< in the order of the file

/// The bytes of a byte array, signed in the format but kept raw here.
struct NbtBytes {
  std::string bytes;
};

/// One value. Byte, short, int and long are all std::int64_t; float and double are double; int and
/// long arrays are one vector. Strings are the file's bytes (modified UTF-8).
struct NbtTag {
  std::variant<std::int64_t, double, std::string, NbtBytes, std::vector<std::int64_t>, NbtList,
               NbtCompound>
      value = std::int64_t(0);

  /// The member of a compound; nullptr when this is none or has no such member.
  const NbtTag* find(std::string_view name) const;
  const std::int64_t* integer() const { return std::get_if<std::int64_t>(&value); }
  const std::string* string() const { return std::get_if<std::string>(&value); }
  const NbtBytes* bytes() const { return std::get_if<NbtBytes>(&value); }
  const NbtCompound* compound() const { return std::get_if<NbtCompound>(&value); }
};

/// Where and why reading stopped.
struct NbtError {
  std::size_t offset = 0;  ///< byte of the uncompressed data
  std::string message;     ///< "the data ends inside \"Palette\""
};

/// Reads a named root compound. Limits: nesting 64, 2^20 tags. nullopt and `error` otherwise.
std::optional<NbtTag> parseNbt(std::string_view data, NbtError& error);

}  // namespace orris
