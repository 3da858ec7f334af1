#include <orris/world/saves/packed_indices.h>

#include <algorithm>
#include <bit>

namespace orris {

int indexBits(std::size_t size, int least) {
  return std::max(least, size > 1 ? int(std::bit_width(size - 1)) : 0);
}

std::size_t PackedIndices::numbersFor(std::size_t count, int bits, bool across) {
  const auto width = std::size_t(bits);
  if (across) return (count * width + 63) / 64;
  const std::size_t each = 64 / width;
  return (count + each - 1) / each;
}

std::uint32_t PackedIndices::at(std::size_t i) const {
  const auto width = std::size_t(bits_);
  const std::uint64_t mask = (std::uint64_t(1) << width) - 1;
  if (!across_) {
    const std::size_t each = 64 / width;
    return std::uint32_t(std::uint64_t(numbers_[i / each]) >> (i % each * width) & mask);
  }
  const std::size_t first = i * width, shift = first % 64;
  std::uint64_t value = std::uint64_t(numbers_[first / 64]) >> shift;
  if (shift + width > 64) value |= std::uint64_t(numbers_[first / 64 + 1]) << (64 - shift);
  return std::uint32_t(value & mask);
}

}  // namespace orris
