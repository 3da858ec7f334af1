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

class SampleRandom {
 public:
  SampleRandom(std::uint64_t seed, std::uint32_t pixel, std::uint32_t sample)
      : state_(mixBits(mixBits(seed) + (std::uint64_t(pixel) << 32 | sample))) {}
  /// Two numbers in [0,1).
  glm::vec2 pair() {
    state_ += 0x9e3779b97f4a7c15u;
    const std::uint64_t bits = mixBits(state_);
    return {float(bits >> 40) * 0x1p-24f, float(bits & 0xffffff) * 0x1p-24f};
  }
  float one() { return pair().x; }

 private:
  std::uint64_t state_;
};

}  // namespace orris
