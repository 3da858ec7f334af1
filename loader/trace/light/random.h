// Random numbers of one sample of one pixel. They depend on nothing but seed, pixel and sample, so
// that neither the number of threads nor the order of work changes a picture.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

namespace orris {

/// splitmix64 of Steele, Lea and Flood 2014.
inline std::uint64_t mixBits(std::uint64_t x) {
  x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9u;
  x = (x ^ x >> 27) * 0x94d049bb133111ebu;
  return x ^ x >> 31;
}

/// The first numbers of a pixel's samples are Weyl sequences, each with its own irrational step and a
/// random start: they cover the unit cube more evenly than chance does, and their mean is as true.
/// The others are plain random numbers.
class SampleRandom {
 public:
  SampleRandom(std::uint64_t seed, std::uint32_t pixel, std::uint32_t sample)
      : start_(mixBits(mixBits(seed) + pixel)),
        state_(mixBits(start_ ^ (std::uint64_t(sample) + 1) * 0xd1342543de82ef95u)),
        sample_(sample) {}

  float one() {
    if (used_ < kEven) return unit(even());
    return unit(std::uint32_t(next() >> 32));
  }
  /// Two numbers in [0,1).
  glm::vec2 pair() {
    if (used_ + 1 < kEven) {
      const std::uint64_t rotation = mixBits(start_ + used_);
      const std::uint32_t first = std::uint32_t(rotation >> 32) + sample_ * kSteps[used_];
      const std::uint32_t second = std::uint32_t(rotation) + sample_ * kSteps[used_ + 1];
      used_ += 2;
      return {unit(first), unit(second)};
    }
    const std::uint64_t bits = next();
    return {unit(std::uint32_t(bits >> 32)), unit(std::uint32_t(bits))};
  }

 private:
  static constexpr std::uint32_t kEven = 10;
  /// Fractions of the square roots of the first primes, times 2^32.
  static constexpr std::uint32_t kSteps[kEven] = {0x6a09e668, 0xbb67ae86, 0x3c6ef373, 0xa54ff53a,
                                                  0x510e5280, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19,
                                                  0xcbbb9d5e, 0x629a292a};
  /// 24 bits, so that 1 is never reached.
  static float unit(std::uint32_t bits) { return float(bits >> 8) * 0x1p-24f; }
  std::uint32_t even() {
    const std::uint32_t which = used_++;
    const auto rotation = std::uint32_t(mixBits(start_ + which) >> 32);
    return rotation + sample_ * kSteps[which];
  }
  std::uint64_t next() { return mixBits(state_ += 0x9e3779b97f4a7c15u); }

  std::uint64_t start_, state_;
  std::uint32_t sample_, used_ = 0;
};

}  // namespace orris
