#include <orris/world/mesh/light.h>

#include <algorithm>
#include <array>

#include <orris/core/parallel.h>

namespace orris {
namespace {

constexpr int kFull = 15;
/// By FaceDirection.
constexpr std::array<glm::ivec3, 6> kNeighbours{
    {{0, -1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}, {-1, 0, 0}, {1, 0, 0}}};
constexpr std::size_t kDown = 0;

/// What blocks do to light, by palette index. `covered` has bit 1 << FaceDirection for a side that
/// lets nothing through, so that stairs and slabs close a roof as in the game.
struct Medium {
  Medium(const BlockWorld& world, const std::vector<BlockFacts>& facts) : blocks(world) {
    for (const BlockFacts& fact : facts) {
      opacity.push_back(std::uint8_t(std::clamp(fact.opacity, 0, kFull)));
      // A full cube stops light by its opacity; its sides must not keep in what it emits.
      covered.push_back(fact.fullOpaqueCube ? std::uint8_t(0) : fact.coveredFaces);
      emission.push_back(std::uint8_t(std::clamp(fact.emission, 0, kFull)));
    }
  }

  bool passes(std::uint32_t from, std::uint32_t to, std::size_t face) const {
    return (covered[from] >> face & 1) == 0 && (covered[to] >> (face ^ 1) & 1) == 0;
  }
  /// What arrives in a block of index `to` from a neighbour of level `from`.
  int arriving(std::uint32_t to, int from) const { return from - std::max<int>(1, opacity[to]); }

  /// The index of all cells of p's section, those outside of the box included.
  std::optional<std::uint32_t> uniform(glm::ivec3 p) const {
    const auto index = blocks.uniformSection(p);
    const glm::ivec3 low = sectionOrigin(p);
    const bool whole = blocks.contains(low) && blocks.contains(low + kSectionSize - 1);
    const glm::ivec3 end = blocks.origin() + blocks.size();
    const bool apart = glm::any(glm::greaterThanEqual(low, end)) ||
                       glm::any(glm::lessThan(low + kSectionSize - 1, blocks.origin()));
    if (apart) return 0;
    return whole || index == 0u ? index : std::nullopt;
  }

  const BlockWorld& blocks;
  std::vector<std::uint8_t> opacity, covered, emission;
};

/// One kind of light over a box, spread from its sources by decreasing level.
class LightField {
 public:
  LightField(LevelGrid& levels, glm::ivec3 origin, glm::ivec3 size, const Medium& medium)
      : levels_(levels), low_(origin), end_(origin + size), medium_(medium) {}

  void spreadBlockLight() {
    forEachSection([&](glm::ivec3 section) {
      const auto only = medium_.uniform(section);
      if (only && medium_.emission[*only] == 0) return;
      forEachCell(section, [&](glm::ivec3 p) {
        const int emission = medium_.emission[medium_.blocks.indexAt(p)];
        if (emission == 0) return;
        levels_.set(p, emission);
        addSource(p, emission);
      });
    });
    spread();
  }

  void spreadSkyLight() {
    const glm::ivec3 first = levels_.firstSection(), count = levels_.sectionCount();
    for (int z = first.z; z < first.z + count.z; ++z) {
      for (int x = first.x; x < first.x + count.x; ++x) lightColumns(x, z);
    }
    // Only lit cells beside darker ones have anything to give.
    forEachSection([&](glm::ivec3 section) {
      if (isAllSky(section)) return;
      forEachCell(section, [&](glm::ivec3 p) {
        if (levels_.at(p) == kFull && gives(p)) addSource(p, kFull);
      });
    });
    spread();
  }

 private:
  bool inside(glm::ivec3 p) const {
    return p.x >= low_.x && p.y >= low_.y && p.z >= low_.z && p.x < end_.x && p.y < end_.y &&
           p.z < end_.z;
  }

  template <class Visit>
  void forEachSection(const Visit& visit) const {
    const glm::ivec3 first = levels_.firstSection(), end = first + levels_.sectionCount();
    for (int y = first.y; y < end.y; ++y)
      for (int z = first.z; z < end.z; ++z)
        for (int x = first.x; x < end.x; ++x) visit(glm::ivec3(x, y, z) * kSectionSize);
  }

  template <class Visit>
  void forEachCell(glm::ivec3 section, const Visit& visit) const {
    const glm::ivec3 low = glm::max(section, low_), end = glm::min(section + kSectionSize, end_);
    for (int y = low.y; y < end.y; ++y)
      for (int z = low.z; z < end.z; ++z)
        for (int x = low.x; x < end.x; ++x) visit(glm::ivec3(x, y, z));
  }

  /// Full light from the top down to what stops it, in the 16x16 columns of a column of sections.
  void lightColumns(int sectionX, int sectionZ) {
    std::array<std::uint32_t, 256> above{};  // outside of the box: air
    std::array<bool, 256> open;
    open.fill(true);
    const glm::ivec3 first = levels_.firstSection(), count = levels_.sectionCount();
    for (int y = first.y + count.y - 1; y >= first.y; --y) {
      const glm::ivec3 section = glm::ivec3(sectionX, y, sectionZ) * kSectionSize;
      const auto only = medium_.uniform(section);
      for (std::size_t i = 0; i < open.size(); ++i)
        open[i] = open[i] && (medium_.covered[above[i]] >> kDown & 1) == 0;
      const auto isOpen = [](bool column) { return column; };
      if (std::none_of(open.begin(), open.end(), isOpen)) return;
      const bool clear = only && medium_.opacity[*only] == 0 && medium_.covered[*only] == 0;
      if (clear && std::all_of(open.begin(), open.end(), isOpen)) {
        levels_.setSection(section, kFull);
        above.fill(*only);
        continue;
      }
      for (std::size_t i = 0; i < open.size(); ++i)
        open[i] = open[i] && lightColumn(section + glm::ivec3(i % 16, 0, i / 16), above[i]);
    }
  }

  /// The 16 cells over `bottom`; false where something stops the light.
  bool lightColumn(glm::ivec3 bottom, std::uint32_t& above) {
    for (int y = kSectionSize - 1; y >= 0; --y) {
      const glm::ivec3 p = bottom + glm::ivec3(0, y, 0);
      const std::uint32_t index = medium_.blocks.indexAt(p);
      if (medium_.opacity[index] != 0 || !medium_.passes(above, index, kDown)) return false;
      levels_.set(p, kFull);
      above = index;
    }
    return true;
  }

  /// Is the section full of sky light, and each beside it?
  bool isAllSky(glm::ivec3 section) const {
    const glm::ivec3 first = levels_.firstSection(), end = first + levels_.sectionCount();
    const auto full = [&](glm::ivec3 q) {
      const glm::ivec3 at = q >> 4;
      const bool held =
          glm::all(glm::greaterThanEqual(at, first)) && glm::all(glm::lessThan(at, end));
      return !held || levels_.uniform(q) == kFull;
    };
    return full(section) &&
           std::all_of(kNeighbours.begin(), kNeighbours.end(),
                       [&](glm::ivec3 step) { return full(section + step * kSectionSize); });
  }

  bool gives(glm::ivec3 p) const {
    return std::any_of(kNeighbours.begin(), kNeighbours.end(), [&](glm::ivec3 step) {
      const glm::ivec3 q = p + step;
      return inside(q) && levels_.at(q) < medium_.arriving(medium_.blocks.indexAt(q), kFull);
    });
  }

  void addSource(glm::ivec3 p, int level) { queues_[std::size_t(level)].push_back(p); }

  void spread() {
    for (std::size_t from = kFull; from > 1; --from) {
      for (std::size_t i = 0; i < queues_[from].size(); ++i) {
        const glm::ivec3 p = queues_[from][i];
        if (levels_.at(p) == int(from)) spreadFrom(p, int(from));
      }
      queues_[from] = {};
    }
  }

  void spreadFrom(glm::ivec3 p, int from) {
    const std::uint32_t here = medium_.blocks.indexAt(p);
    for (std::size_t face = 0; face < kNeighbours.size(); ++face) {
      const glm::ivec3 q = p + kNeighbours[face];
      if (!inside(q)) continue;
      const int level = levels_.at(q);
      if (level >= from - 1) continue;
      const std::uint32_t index = medium_.blocks.indexAt(q);
      const int arrived = medium_.arriving(index, from);
      if (arrived <= level || !medium_.passes(here, index, face)) continue;
      levels_.set(q, arrived);
      addSource(q, arrived);
    }
  }

  LevelGrid& levels_;
  glm::ivec3 low_, end_;
  const Medium& medium_;
  std::array<std::vector<glm::ivec3>, kFull + 1> queues_;
};

}  // namespace

LightLevels::LightLevels(const BlockWorld& blocks, const std::vector<BlockFacts>& factsByPalette,
                         bool skylight)
    : origin_(blocks.origin() - 1),
      size_(blocks.size() + 2),
      block_(origin_, size_),
      sky_(origin_, size_),
      outsideSky_(skylight ? kFull : 0) {
  const Medium medium(blocks, factsByPalette);
  forEachInParallel(2, [&](std::size_t kind) {
    if (kind == 0) LightField(block_, origin_, size_, medium).spreadBlockLight();
    if (kind == 1 && skylight) LightField(sky_, origin_, size_, medium).spreadSkyLight();
  });
}

}  // namespace orris
