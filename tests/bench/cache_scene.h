// A closed room for comparing caches of light: its inner faces, points that a picture sees, and the reference
// at them.
#pragma once

#include <optional>

#include <orris/trace/reference_scene.h>

namespace orris {

/// Uniform in density cos/pi about n.
glm::vec3 cosineAbout(const glm::vec3& n, SampleRandom& random);

struct RoomPoint {
  TraceSurface surface;
  glm::vec3 reference{0};  ///< mean incoming radiance, of all bounces
  glm::vec3 direct{0};  ///< of it, what comes from lamps without a bounce
};

/// A world without a way out, at night: no sun, no sky.
class Room {
 public:
  /// `samples` paths at each of `columns` x 9/16 points.
  static std::optional<Room> open(const std::string& world, int columns, int samples);

  const VoxelGrid& grid() const { return reference_->scene.grid; }
  const std::vector<RoomPoint>& points() const { return points_; }
  /// Indices of the quads that light can reach.
  const std::vector<std::uint32_t>& faces() const { return faces_; }
  /// Where a ray that met `hit` goes on.
  TraceSurface surfaceAt(const RayHit& hit) const;
  TraceSurface onFace(std::uint32_t quad, SampleRandom& random) const;
  RayHit cosineHit(const TraceSurface& from, SampleRandom& random) const;
  /// One sample of the lamps' light without a bounce: a ray to a lamp and a cosine ray, weighed.
  glm::vec3 directAt(const TraceSurface& surface, SampleRandom& random) const;
  /// Radiance of the lamp that was met; 0 where it is none.
  glm::vec3 lampOf(const RayHit& hit) const;

 private:
  std::shared_ptr<const ReferenceScene> reference_;
  std::vector<std::uint32_t> faces_;
  std::vector<RoomPoint> points_;
};

}  // namespace orris
