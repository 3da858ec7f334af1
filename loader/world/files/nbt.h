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
  const NbtList* list() const { return std::get_if<NbtList>(&value); }
  const NbtCompound* compound() const { return std::get_if<NbtCompound>(&value); }

  /// The whole number that is member `name`; `fallback` when there is none.
  std::int64_t integerAt(std::string_view name, std::int64_t fallback = 0) const;
  /// The string that is member `name`; "" when there is none.
  const std::string& stringAt(std::string_view name) const;
  /// The list that is member `name`; nullptr when there is none.
  const NbtList* listAt(std::string_view name) const;
  /// The numbers of an array of integers or a list of reals, member `name`; none when it is neither.
  std::vector<double> numbersAt(std::string_view name) const;
};

/// Where and why reading stopped.
struct NbtError {
  std::size_t offset = 0;  ///< byte of the uncompressed data
  std::string message;     ///< "the data ends inside \"Palette\""
};

/// Reads a named root compound. Limits: nesting 64, 2^20 tags. nullopt and `error` otherwise.
std::optional<NbtTag> parseNbt(std::string_view data, NbtError& error);

}  // namespace orris
