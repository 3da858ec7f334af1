#include <orris/world/files/nbt.h>

#include <fmt/core.h>

#include <bit>
#include <cassert>

namespace orris {
namespace {

constexpr int kMaxTagDepth = 64;
constexpr std::size_t kMaxTags = std::size_t(1) << 20;

enum TagType : std::uint8_t {
  End,
  Byte,
  Short,
  Int,
  Long,
  Float,
  Double,
  ByteArray,
  String,
  List,
  Compound,
  IntArray,
  LongArray
};

class NbtReader {
 public:
  NbtReader(std::string_view data, NbtError& error) : data_(data), error_(error) {}

  std::optional<NbtTag> root() {
    if (data_.empty() || std::uint8_t(data_[0]) != Compound) {
      fail("expected a compound tag (byte 10)");
      return std::nullopt;
    }
    position_ = 1;
    NbtTag tag;
    if (!readName(name_) || !readCompound(tag, 1)) return std::nullopt;
    return tag;
  }

 private:
  bool fail(std::string message) {
    error_ = {position_, std::move(message)};
    return false;
  }

  bool need(std::size_t count) {
    if (data_.size() - position_ >= count) return true;
    return fail(name_.empty() ? "the data ends too early"
                              : fmt::format("the data ends inside \"{}\"", name_));
  }

  bool readUnsigned(int bytes, std::uint64_t& value) {
    if (!need(std::size_t(bytes))) return false;
    value = 0;
    for (int i = 0; i < bytes; ++i) value = value << 8 | std::uint8_t(data_[position_++]);
    return true;
  }

  bool readInteger(int bytes, std::int64_t& value) {
    std::uint64_t raw = 0;
    if (!readUnsigned(bytes, raw)) return false;
    const int unused = 64 - 8 * bytes;
    value = std::int64_t(raw << unused) >> unused;
    return true;
  }

  bool readName(std::string& text) {
    std::uint64_t length = 0;
    if (!readUnsigned(2, length) || !need(length)) return false;
    text.assign(data_.substr(position_, length));
    position_ += length;
    return true;
  }

  /// An element count whose elements take `elementBytes` each; what does not fit is refused before
  /// anything is allocated for it.
  bool readCount(std::size_t elementBytes, std::size_t& count) {
    std::int64_t value = 0;
    if (!readInteger(4, value)) return false;
    if (value < 0) return fail(fmt::format("\"{}\" has the negative length {}", name_, value));
    count = std::size_t(value);
    return need(count * elementBytes);
  }

  bool readIntegers(int bytes, NbtTag& tag) {
    std::size_t count = 0;
    if (!readCount(std::size_t(bytes), count)) return false;
    std::vector<std::int64_t> values(count);
    for (std::int64_t& value : values) {
      if (!readInteger(bytes, value)) return false;
    }
    tag.value = std::move(values);
    return true;
  }

  bool readBytes(NbtTag& tag) {
    std::size_t count = 0;
    if (!readCount(1, count)) return false;
    tag.value = NbtBytes{std::string(data_.substr(position_, count))};
    position_ += count;
    return true;
  }

  bool readReal(int bytes, NbtTag& tag) {
    std::uint64_t raw = 0;
    if (!readUnsigned(bytes, raw)) return false;
    tag.value =
        bytes == 4 ? double(std::bit_cast<float>(std::uint32_t(raw))) : std::bit_cast<double>(raw);
    return true;
  }

  bool readList(NbtTag& tag, int depth) {
    std::uint64_t type = 0;
    if (!readUnsigned(1, type)) return false;
    std::size_t count = 0;
    // Every element takes a byte at least, but for those of a list of End, which must be empty.
    if (!readCount(type == End ? 0 : 1, count)) return false;
    if (type == End && count > 0)
      return fail(fmt::format("\"{}\" lists values without type", name_));
    NbtList list;
    for (std::size_t i = 0; i < count; ++i) {
      if (!readValue(std::uint8_t(type), list.emplace_back(), depth)) return false;
    }
    tag.value = std::move(list);
    return true;
  }

  bool readCompound(NbtTag& tag, int depth) {
    NbtCompound compound;
    while (true) {
      std::uint64_t type = 0;
      if (!readUnsigned(1, type)) return false;
      if (type == End) break;
      std::string name;
      if (!readName(name)) return false;
      name_ = name;
      NbtTag& member = compound.emplace_back(std::move(name), NbtTag{}).second;
      if (!readValue(std::uint8_t(type), member, depth)) return false;
    }
    tag.value = std::move(compound);
    return true;
  }

  bool readValue(std::uint8_t type, NbtTag& tag, int depth) {
    if (++tags_ > kMaxTags) return fail(fmt::format("more than {} tags", kMaxTags));
    if ((type == List || type == Compound) && depth >= kMaxTagDepth) {
      return fail(fmt::format("\"{}\" is nested deeper than {}", name_, kMaxTagDepth));
    }
    std::int64_t integer = 0;
    switch (type) {
      case Byte:
        return readInteger(1, integer) && assign(tag, integer);
      case Short:
        return readInteger(2, integer) && assign(tag, integer);
      case Int:
        return readInteger(4, integer) && assign(tag, integer);
      case Long:
        return readInteger(8, integer) && assign(tag, integer);
      case Float:
        return readReal(4, tag);
      case Double:
        return readReal(8, tag);
      case ByteArray:
        return readBytes(tag);
      case String:
        return readName(tag.value.emplace<std::string>());
      case List:
        return readList(tag, depth + 1);
      case Compound:
        return readCompound(tag, depth + 1);
      case IntArray:
        return readIntegers(4, tag);
      case LongArray:
        return readIntegers(8, tag);
      default:
        return fail(fmt::format("\"{}\" has the unknown tag type {}", name_, type));
    }
  }

  static bool assign(NbtTag& tag, std::int64_t value) {
    tag.value = value;
    return true;
  }

  std::string_view data_;
  NbtError& error_;
  std::size_t position_ = 0;
  std::size_t tags_ = 0;
  std::string name_;  // of the member being read, for messages
};

}  // namespace

const NbtTag* NbtTag::find(std::string_view name) const {
  const NbtCompound* members = compound();
  if (!members) return nullptr;
  for (const auto& [key, tag] : *members) {
    if (key == name) return &tag;
  }
  return nullptr;
}

std::int64_t NbtTag::integerAt(std::string_view name, std::int64_t fallback) const {
  const NbtTag* tag = find(name);
  return tag && tag->integer() ? *tag->integer() : fallback;
}

std::vector<double> NbtTag::numbersAt(std::string_view name) const {
  std::vector<double> numbers;
  const NbtTag* tag = find(name);
  if (!tag) return numbers;
  if (const auto* array = std::get_if<std::vector<std::int64_t>>(&tag->value))
    numbers.assign(array->begin(), array->end());
  if (const NbtList* list = tag->list()) {
    for (const NbtTag& item : *list) {
      if (const auto* real = std::get_if<double>(&item.value)) numbers.push_back(*real);
    }
  }
  return numbers;
}

const NbtList* NbtTag::listAt(std::string_view name) const {
  const NbtTag* tag = find(name);
  return tag ? tag->list() : nullptr;
}

const std::string& NbtTag::stringAt(std::string_view name) const {
  static const std::string kNone;
  const NbtTag* tag = find(name);
  return tag && tag->string() ? *tag->string() : kNone;
}

std::optional<NbtTag> parseNbt(std::string_view data, NbtError& error) {
  return NbtReader(data, error).root();
}

}  // namespace orris
