// Rays to a light past whole caster faces: what shadow volumes should show, without what their casters lack (holes, glass,
// plants). Shares nothing with the volumes but what casts.
#pragma once

#include <unordered_map>
#include <vector>

#include <orris/trace/shadow_mask.h>
#include <orris/world/mesh/casters.h>

namespace orris::test {

/// Caster faces by cell, for rays in double precision.
class CasterRays {
 public:
  explicit CasterRays(const CasterSet& casters);
  /// Does any face lie between `from` and `to`? Both in world blocks; with `toward.w` 0 its xyz is a
  /// direction and the ray never ends.
  bool blocked(const glm::dvec3& from, const glm::dvec4& toward) const;
  /// The same for shadowMask(), while this lives.
  LightStopped stopping() const;

 private:
  struct Quad {
    glm::dvec3 corners[4];
    glm::dvec3 normal;
  };
  static std::uint64_t keyOf(const glm::ivec3& cell);
  bool blockedIn(const glm::ivec3& cell, const glm::dvec3& from, const glm::dvec3& direction,
                 double end) const;
  std::vector<Quad> quads_;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> byCell_;
  glm::dvec3 low_{0}, high_{0};
};

}  // namespace orris::test
