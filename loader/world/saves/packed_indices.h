// Palette indices packed into 64-bit numbers: of chunks, and of Litematica's regions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace orris {

/// Bits of an index into a palette of `size` entries, at least `least`.
int indexBits(std::size_t size, int least);

/// Numbers of `bits` bits (1 to 32), lowest first.
class PackedIndices {
 public:
  /// `across`: an index may begin in one number and end in the next, as the game packed before 1.16.
  PackedIndices(std::span<const std::int64_t> numbers, int bits, bool across)
      : numbers_(numbers), bits_(bits), across_(across) {}

  /// 64-bit numbers that `count` indices take.
  static std::size_t numbersFor(std::size_t count, int bits, bool across);
  /// `i` is below the count whose numbers there are.
  std::uint32_t at(std::size_t i) const;

 private:
  std::span<const std::int64_t> numbers_;
  int bits_;
  bool across_;
};

}  // namespace orris
