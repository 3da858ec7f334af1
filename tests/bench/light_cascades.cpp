// Radiance cascades: many probes that look a little way in few directions, few that look far in many.
// Level i has a probe every 2^i cells, (4 2^i)^2 directions, and looks 1.5 (4^(i+1) - 1) / 3 cells far.
#include <array>

#include "light_caches.h"

namespace orris {
namespace {

constexpr int kLevels = 4;
constexpr float kFirstReach = 1.5f;

/// A point of the unit square to a direction: the octahedral map.
glm::vec3 octahedral(glm::vec2 at) {
  glm::vec2 p = at * 2.0f - 1.0f;
  glm::vec3 n(p, 1 - std::abs(p.x) - std::abs(p.y));
  if (n.z < 0) {
    const glm::vec2 sign(n.x >= 0 ? 1 : -1, n.y >= 0 ? 1 : -1);
    n = glm::vec3((1.0f - glm::abs(glm::vec2(n.y, n.x))) * sign, n.z);
  }
  return glm::normalize(n);
}

int directionsAlong(int level) { return 4 << level; }
/// How far a level looks.
float wayEnds(int level) {
  float reach = 0;
  for (int i = 0; i <= level; ++i) reach += kFirstReach * float(1 << 2 * i);
  return reach;
}

class Cascades : public LightCache {
 public:
  explicit Cascades(const Room& room) : LightCache(room) {
    for (int level = 0; level < kLevels; ++level) {
      Level& made = levels_[std::size_t(level)];
      made.size = (room.grid().size() + (1 << level) - 1) >> level;
      made.radiance.resize(std::size_t(made.size.x * made.size.y * made.size.z) *
                           std::size_t(directionsAlong(level) * directionsAlong(level)));
      made.valid.resize(std::size_t(made.size.x * made.size.y * made.size.z));
    }
    for (const std::uint32_t face : room.faces())
      isFace_.resize(std::max(isFace_.size(), std::size_t(face) + 1));
    for (const std::uint32_t face : room.faces()) isFace_[face] = true;
    weighDirections();
  }

  void frame(SampleRandom& random) override {
    for (int level = kLevels - 1; level >= 0; --level) trace(level, random);
    // Probes of this frame looked into those of the frame before.
    settled_ = levels_[0];
  }

  glm::vec3 light(const RayHit& hit) const override {
    if (settled_.radiance.empty()) return glm::vec3(0);
    const TraceSurface surface = room_.surfaceAt(hit);
    const glm::vec3 place = surface.position + 0.5f * surface.normal;
    std::size_t side = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (std::abs(surface.normal[int(axis)]) > 0.5f)
        side = 2 * axis + (surface.normal[int(axis)] < 0);
    glm::vec3 sum(0);
    float weights = 0;
    forEachAbout(settled_, 0, place, [&](std::size_t probe, float weight) {
      for (std::size_t d = 0; d < 16; ++d)
        sum += weight * cosines_[side][d] * settled_.radiance[probe * 16 + d];
      weights += weight;
    });
    return weights > 0 ? sum / weights : glm::vec3(0);
  }

  std::size_t kept() const override {
    std::size_t sum = 0;
    for (const Level& level : levels_) sum += level.radiance.size();
    return sum;
  }

 private:
  struct Level {
    glm::ivec3 size{0};
    std::vector<glm::vec3> radiance;  ///< by probe, then direction
    std::vector<char> valid;          ///< by probe: in the open
  };

  /// Shares of the hemisphere of each face's normal, by direction of the first level.
  void weighDirections() {
    constexpr int kSub = 16;
    for (std::size_t side = 0; side < 6; ++side) {
      float all = 0;
      for (int y = 0; y < 4 * kSub; ++y)
        for (int x = 0; x < 4 * kSub; ++x) {
          const glm::vec2 at = (glm::vec2(x, y) + 0.5f) / float(4 * kSub);
          const glm::vec3 d = octahedral(at);
          // Texels of the map stand for unequal solid angles.
          const float solid = std::pow(std::abs(d.x) + std::abs(d.y) + std::abs(d.z), 3.0f);
          const float cosine = std::max(0.0f, d[int(side / 2)] * (side % 2 == 0 ? 1.0f : -1.0f));
          cosines_[side][std::size_t(y / kSub * 4 + x / kSub)] += cosine * solid;
          all += cosine * solid;
        }
      for (float& share : cosines_[side]) share /= all;
    }
  }

  static glm::vec3 middle(int level, glm::ivec3 probe) {
    return (glm::vec3(probe) + 0.5f) * float(1 << level);
  }

  template <class Visit>
  static void forEachAbout(const Level& level, int number, const glm::vec3& place,
                           const Visit& visit) {
    const glm::vec3 at = place / float(1 << number) - 0.5f;
    const glm::ivec3 low(glm::floor(at));
    for (int corner = 0; corner < 8; ++corner) {
      const glm::ivec3 p = low + glm::ivec3(corner & 1, corner >> 1 & 1, corner >> 2);
      if (glm::any(glm::lessThan(p, glm::ivec3(0))) ||
          glm::any(glm::greaterThanEqual(p, level.size)))
        continue;
      const auto probe = std::size_t(p.x + level.size.x * (p.z + level.size.z * p.y));
      if (!level.valid[probe]) continue;
      const glm::vec3 near = 1.0f - glm::abs(at - glm::vec3(p));
      visit(probe, std::max(near.x * near.y * near.z, 1e-4f));
    }
  }

  void trace(int number, SampleRandom& random) {
    Level& level = levels_[std::size_t(number)];
    for (int y = 0; y < level.size.y; ++y)
      for (int z = 0; z < level.size.z; ++z)
        for (int x = 0; x < level.size.x; ++x)
          traceProbe(number, {x, y, z}, std::size_t(x + level.size.x * (z + level.size.z * y)),
                     random);
  }

  void traceProbe(int number, glm::ivec3 at, std::size_t probe, SampleRandom& random) {
    Level& level = levels_[std::size_t(number)];
    const glm::vec3 origin = middle(number, at);
    const glm::ivec3 cell(glm::floor(origin));
    const int along = directionsAlong(number);
    level.valid[probe] = isInside(origin, cell);
    if (!level.valid[probe]) return;
    for (int i = 0; i < along * along; ++i) {
      const glm::vec2 place((float(i % along) + random.one()) / float(along),
                            (float(i / along) + random.one()) / float(along));
      level.radiance[probe * std::size_t(along * along) + std::size_t(i)] =
          radianceAlong(number, origin, cell, octahedral(place), i);
    }
  }

  /// Of one direction: what is met on this level's way, or what the next level sees beyond it.
  glm::vec3 radianceAlong(int number, const glm::vec3& origin, glm::ivec3 cell,
                          const glm::vec3& direction, int index) {
    Ray ray;
    ray.direction = withoutZeros(direction);
    ray.origin = origin;
    ray.cell = cell;
    const RayHit hit = room_.grid().intersect(ray);
    ++rays_;
    const float end = wayEnds(number);
    // What is met before this level's way counts as well: dark instead, corners lose half of their light.
    if (number == kLevels - 1 || hit.distance < end) return room_.lampOf(hit) + reflected(hit);
    const Level& next = levels_[std::size_t(number) + 1];
    const int along = directionsAlong(number), finer = 2 * along;
    glm::vec3 sum(0);
    float weights = 0;
    forEachAbout(next, number + 1, origin, [&](std::size_t probe, float weight) {
      const glm::vec3* from = &next.radiance[probe * std::size_t(finer * finer)];
      for (int child = 0; child < 4; ++child) {
        const int x = index % along * 2 + child % 2, y = index / along * 2 + child / 2;
        sum += 0.25f * weight * from[y * finer + x];
      }
      weights += weight;
    });
    return weights > 0 ? sum / weights : glm::vec3(0);
  }

  /// In a cell of air that faces of the room enclose.
  bool isInside(const glm::vec3& origin, glm::ivec3 cell) {
    if (!room_.grid().contains(cell) || room_.grid().isOpen(cell)) return false;
    Ray ray;
    ray.origin = origin + glm::vec3(1e-3f, 2e-3f, 3e-3f);
    ray.direction = withoutZeros(glm::vec3(0, 1, 0));
    ray.cell = cell;
    const RayHit hit = room_.grid().intersect(ray);
    return hit.quad < isFace_.size() && isFace_[hit.quad] && !hit.back;
  }

  std::array<Level, kLevels> levels_;
  Level settled_;
  std::array<std::array<float, 16>, 6> cosines_{};
  std::vector<char> isFace_;
};

}  // namespace

std::unique_ptr<LightCache> makeCascades(const Room& room) {
  return std::make_unique<Cascades>(room);
}

}  // namespace orris
