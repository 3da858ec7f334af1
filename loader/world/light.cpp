#include "world/light.h"

#include <algorithm>
#include <array>

namespace orris {
namespace {

constexpr int kFull = 15;
constexpr std::array<glm::ivec3, 6> kNeighbours{
    {{0, -1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}, {-1, 0, 0}, {1, 0, 0}}};

/// One kind of light over the grown box, spread from its sources by decreasing level.
class LightField {
 public:
  LightField(glm::ivec3 size, const std::vector<std::uint8_t>& opacity)
      : size_(size), opacity_(opacity), levels_(opacity.size()) {}

  std::size_t offset(glm::ivec3 p) const {
    return (std::size_t(p.y) * size_.z + p.z) * size_.x + p.x;
  }
  int level(glm::ivec3 p) const { return levels_[offset(p)]; }
  void set(glm::ivec3 p, int level) { levels_[offset(p)] = std::uint8_t(level); }
  void addSource(glm::ivec3 p) { queues_[std::size_t(level(p))].push_back(p); }
  std::vector<std::uint8_t> take() { return std::move(levels_); }

  bool inside(glm::ivec3 p) const {
    return p.x >= 0 && p.y >= 0 && p.z >= 0 && p.x < size_.x && p.y < size_.y && p.z < size_.z;
  }

  /// What arrives in `p` from a neighbour of level `from`.
  int arriving(glm::ivec3 p, int from) const {
    return from - std::max<int>(1, opacity_[offset(p)]);
  }

  void spread() {
    for (std::size_t from = kFull; from > 1; --from) {
      for (std::size_t i = 0; i < queues_[from].size(); ++i) {
        const glm::ivec3 p = queues_[from][i];
        if (level(p) == int(from)) spreadFrom(p, int(from));
      }
      queues_[from] = {};
    }
  }

 private:
  void spreadFrom(glm::ivec3 p, int from) {
    for (const glm::ivec3 step : kNeighbours) {
      const glm::ivec3 q = p + step;
      if (!inside(q)) continue;
      const int arrived = arriving(q, from);
      if (arrived <= level(q)) continue;
      set(q, arrived);
      addSource(q);
    }
  }

  glm::ivec3 size_;
  const std::vector<std::uint8_t>& opacity_;
  std::vector<std::uint8_t> levels_;
  std::array<std::vector<glm::ivec3>, kFull + 1> queues_;
};

template <class Visit>
void forEachCell(glm::ivec3 size, Visit visit) {
  for (int y = 0; y < size.y; ++y) {
    for (int z = 0; z < size.z; ++z) {
      for (int x = 0; x < size.x; ++x) visit(glm::ivec3(x, y, z));
    }
  }
}

std::vector<std::uint8_t> skyLight(glm::ivec3 size, const std::vector<std::uint8_t>& opacity) {
  LightField field(size, opacity);
  for (int z = 0; z < size.z; ++z) {
    for (int x = 0; x < size.x; ++x) {
      for (int y = size.y - 1; y >= 0 && opacity[field.offset({x, y, z})] == 0; --y) {
        field.set({x, y, z}, kFull);
      }
    }
  }
  // Only lit cells beside darker ones have anything to give.
  forEachCell(size, [&](glm::ivec3 p) {
    if (field.level(p) != kFull) return;
    const bool gives = std::any_of(kNeighbours.begin(), kNeighbours.end(), [&](glm::ivec3 step) {
      const glm::ivec3 q = p + step;
      return field.inside(q) && field.level(q) < field.arriving(q, kFull);
    });
    if (gives) field.addSource(p);
  });
  field.spread();
  return field.take();
}

}  // namespace

LightLevels::LightLevels(const BlockWorld& blocks, const std::vector<BlockFacts>& factsByPalette)
    : origin_(blocks.origin() - 1), size_(blocks.size() + 2) {
  std::vector<std::uint8_t> opacity(std::size_t(size_.x) * size_.y * size_.z);
  LightField field(size_, opacity);
  forEachCell(size_, [&](glm::ivec3 p) {
    const BlockFacts& facts = factsByPalette[blocks.indexAt(origin_ + p)];
    opacity[field.offset(p)] = std::uint8_t(std::clamp(facts.opacity, 0, kFull));
    if (facts.emission <= 0) return;
    field.set(p, std::min(facts.emission, kFull));
    field.addSource(p);
  });
  field.spread();
  levels_ = field.take();
  const std::vector<std::uint8_t> sky = skyLight(size_, opacity);
  for (std::size_t i = 0; i < levels_.size(); ++i) levels_[i] |= std::uint8_t(sky[i] << 4);
}

int LightLevels::block(glm::ivec3 p) const {
  const glm::ivec3 q = p - origin_;
  const bool inside =
      glm::all(glm::greaterThanEqual(q, glm::ivec3(0))) && glm::all(glm::lessThan(q, size_));
  return inside ? levels_[offset(p)] & 15 : 0;
}

int LightLevels::sky(glm::ivec3 p) const {
  const glm::ivec3 q = p - origin_;
  const bool inside =
      glm::all(glm::greaterThanEqual(q, glm::ivec3(0))) && glm::all(glm::lessThan(q, size_));
  return inside ? levels_[offset(p)] >> 4 : kFull;
}

std::size_t LightLevels::offset(glm::ivec3 p) const {
  const glm::ivec3 q = p - origin_;
  return (std::size_t(q.y) * size_.z + q.z) * size_.x + q.x;
}

}  // namespace orris
