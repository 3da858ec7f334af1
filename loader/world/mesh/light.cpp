#include "world/mesh/light.h"

#include <algorithm>
#include <array>

namespace orris {
namespace {

constexpr int kFull = 15;
/// By FaceDirection.
constexpr std::array<glm::ivec3, 6> kNeighbours{
    {{0, -1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}, {-1, 0, 0}, {1, 0, 0}}};

/// What the cells of the grown box do to light. `covered` has bit 1 << FaceDirection for a side that
/// lets nothing through, so that stairs and slabs close a roof as in the game.
struct Medium {
  explicit Medium(std::size_t cells) : opacity(cells), covered(cells) {}
  std::vector<std::uint8_t> opacity, covered;

  bool passes(std::size_t from, std::size_t to, std::size_t face) const {
    return (covered[from] >> face & 1) == 0 && (covered[to] >> (face ^ 1) & 1) == 0;
  }
};

/// One kind of light over the grown box, spread from its sources by decreasing level.
class LightField {
 public:
  LightField(glm::ivec3 size, const Medium& medium)
      : size_(size), medium_(medium), levels_(medium.opacity.size()) {}

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
    return from - std::max<int>(1, medium_.opacity[offset(p)]);
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
    for (std::size_t face = 0; face < kNeighbours.size(); ++face) {
      const glm::ivec3 q = p + kNeighbours[face];
      if (!inside(q) || !medium_.passes(offset(p), offset(q), face)) continue;
      const int arrived = arriving(q, from);
      if (arrived <= level(q)) continue;
      set(q, arrived);
      addSource(q);
    }
  }

  glm::ivec3 size_;
  const Medium& medium_;
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

std::vector<std::uint8_t> skyLight(glm::ivec3 size, const Medium& medium) {
  constexpr std::size_t kDown = 0;
  LightField field(size, medium);
  for (int z = 0; z < size.z; ++z) {
    for (int x = 0; x < size.x; ++x) {
      std::size_t above = field.offset({x, size.y - 1, z});
      for (int y = size.y - 1; y >= 0; --y) {
        const std::size_t cell = field.offset({x, y, z});
        if (medium.opacity[cell] != 0 || (cell != above && !medium.passes(above, cell, kDown)))
          break;
        field.set({x, y, z}, kFull);
        above = cell;
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
  Medium medium(std::size_t(size_.x) * size_.y * size_.z);
  LightField field(size_, medium);
  forEachCell(size_, [&](glm::ivec3 p) {
    const BlockFacts& facts = factsByPalette[blocks.indexAt(origin_ + p)];
    medium.opacity[field.offset(p)] = std::uint8_t(std::clamp(facts.opacity, 0, kFull));
    // A full cube stops light by its opacity; its sides must not keep in what it emits.
    if (!facts.fullOpaqueCube) medium.covered[field.offset(p)] = facts.coveredFaces;
    if (facts.emission <= 0) return;
    field.set(p, std::min(facts.emission, kFull));
    field.addSource(p);
  });
  field.spread();
  levels_ = field.take();
  const std::vector<std::uint8_t> sky = skyLight(size_, medium);
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
