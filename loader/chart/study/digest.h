// Fingerprints that tell whether something changed between two runs. Not for secrets.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <type_traits>

namespace orris {

/// FNV-1a, 64 bits.
class Digest {
 public:
  Digest& addBytes(const void* data, std::size_t size) {
    const auto* bytes = static_cast<const unsigned char*>(data);
    for (std::size_t i = 0; i < size; ++i) value_ = (value_ ^ bytes[i]) * 0x100000001b3u;
    return *this;
  }
  /// With its length, so that texts cannot run into each other.
  Digest& add(std::string_view text) { return add(text.size()).addBytes(text.data(), text.size()); }
  template <class T>
  requires std::is_arithmetic_v<T> Digest& add(T value) { return addBytes(&value, sizeof value); }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325u;
};

}  // namespace orris
