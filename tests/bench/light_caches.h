// Caches of light to compare with the face cache of the pack (docs/results/caches.md).
#pragma once

#include <memory>
#include <string>

#include "cache_scene.h"

namespace orris {

class LightCache {
 public:
  explicit LightCache(const Room& room) : room_(room) {}
  virtual ~LightCache() = default;
  virtual void frame(SampleRandom& random) = 0;
  /// Mean incoming radiance where a ray met a face.
  virtual glm::vec3 light(const RayHit& hit) const = 0;
  /// Numbers of 8 bytes that it keeps.
  virtual std::size_t kept() const = 0;
  std::uint64_t rays() const { return rays_; }

 protected:
  /// Of a ray that met a face: what the face reflects of the light it has.
  glm::vec3 reflected(const RayHit& hit) const;
  /// One sample for a point: lamps directly, then one bounce into the cache. Two rays, since the
  /// cosine ray of both can be the same.
  glm::vec3 sampleAt(const TraceSurface& surface, SampleRandom& random, RayHit& hit);

  const Room& room_;
  std::uint64_t rays_ = 0;
};

struct NamedCache {
  std::string name;
  std::unique_ptr<LightCache> cache;
};
std::vector<NamedCache> makeLightCaches(const Room& room);

/// Radiance cascades (Sannikov 2023) in three dimensions.
std::unique_ptr<LightCache> makeCascades(const Room& room);

}  // namespace orris
