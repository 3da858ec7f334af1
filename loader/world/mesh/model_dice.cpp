#include <orris/world/mesh/model_dice.h>

#include <cstdlib>
#include <numeric>

namespace orris {
namespace {

// Java's numbers overflow where C++'s may not: all is done without signs.
std::int64_t placeSeed(glm::ivec3 cell) {
  const auto x = std::int32_t(std::uint32_t(cell.x) * 3129871u);
  std::uint64_t seed = std::uint64_t(std::int64_t(x)) ^
                       std::uint64_t(std::int64_t(cell.z)) * 116129781u ^
                       std::uint64_t(std::int64_t(cell.y));
  seed = seed * seed * 42317861u + seed * 11u;
  return std::int64_t(seed) >> 16;
}

/// The second call's numbers of java.util.Random's nextLong().
std::int64_t nextLong(std::int64_t seed) {
  constexpr std::uint64_t kFactor = 0x5DEECE66Du, kMask = (std::uint64_t{1} << 48) - 1;
  std::uint64_t state = (std::uint64_t(seed) ^ kFactor) & kMask;
  const auto next = [&] {
    state = (state * kFactor + 0xBu) & kMask;
    return std::int32_t(std::uint32_t(state >> 16));
  };
  const std::int32_t high = next(), low = next();
  return std::int64_t((std::uint64_t(std::int64_t(high)) << 32) + std::uint64_t(std::int64_t(low)));
}

}  // namespace

ModelDice::ModelDice(glm::ivec3 cell, bool multipart) {
  std::int64_t seed = placeSeed(cell);
  if (multipart) seed = nextLong(seed);
  thrown_ = std::int32_t(std::uint32_t(std::uint64_t(nextLong(seed))));
}

std::size_t ModelDice::choose(const std::vector<int>& weights) const {
  if (weights.size() < 2) return 0;
  const std::int64_t total = std::accumulate(weights.begin(), weights.end(), std::int64_t{0});
  std::int64_t rest = std::abs(std::int64_t(thrown_)) % total;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    rest -= weights[i];
    if (rest < 0) return i;
  }
  return 0;
}

}  // namespace orris
