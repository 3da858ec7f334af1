// The reference for shadows of one light: for each pixel whether the light reaches what it shows, by a
// ray to the light past whole caster faces. Shares nothing with shadow volumes but what casts.
#pragma once

#include <unordered_map>
#include <vector>

#include <orris/image/image.h>
#include <orris/trace/path_tracer.h>
#include <orris/world/mesh/casters.h>

namespace orris {

/// Caster faces by cell, for rays in double precision.
class CasterRays {
 public:
  explicit CasterRays(const CasterSet& casters);
  /// Does any face lie between `from` and `to`? Both in world blocks; with `toward.w` 0 its xyz is a
  /// direction and the ray never ends.
  bool blocked(const glm::dvec3& from, const glm::dvec4& toward) const;

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

/// Faces whose cosine with the light is smaller count as turned away: the normals of the frame have
/// eight bits, so there rounding decides.
constexpr double kGrazing = 0.01;

/// A frame of the same view. Whether a texel of a cutout is a hole two texture units may answer
/// differently, where its alpha is close to the test's: then the frame shows another surface than the
/// pixel's ray meets first, and light is judged there.
struct ShownFrame {
  ImageF depth;          ///< its depth buffer
  long long others = 0;  ///< counts such pixels
};

/// One channel: 1 lit, also where no block is seen; 0 in shadow or turned away. Where the answer
/// changes within the pixel, or within what a frame can know of its middle, lit is 0.75 and dark
/// 0.25. `light`: w 0 and the direction to it, or w 1 and its place in world blocks. What is seen through water is judged, not
/// the water; leaves and plants that turn away are lit through.
ImageF shadowMask(const TraceScene& scene, const TraceCamera& camera, const CasterRays& casters,
                  const glm::dvec4& light, ShownFrame* shown = nullptr);

}  // namespace orris
