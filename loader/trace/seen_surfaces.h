// What pixels show of opaque blocks, as the path tracer finds it, and as a frame may show it instead.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include <orris/trace/path_tracer.h>

namespace orris {

/// What a frame knows of a place: where in the picture to this part of a pixel (rasterisers put corners
/// on a grid of 1/256), and how far to this part of the range of depth (16 steps of 24 bits).
constexpr double kFramePixel = 1.0 / 256;
constexpr double kFrameDepth = 16.0 / (1 << 24);

struct SeenSurface {
  const TraceQuad* quad = nullptr;    ///< nullptr: the sky
  glm::dvec3 position{0}, normal{0};  ///< grid space; normal toward the eye
};

/// Points of a picture are in pixels from its top left corner.
class SeenSurfaces {
 public:
  SeenSurfaces(const TraceScene& scene, const TraceCamera& camera);

  /// The first opaque surface, and those that follow so close that a frame may show them instead.
  /// `depth`: part of the range of depth.
  std::vector<SeenSurface> at(double px, double py, double depth) const;
  /// Of all surfaces that the ray meets, holes or not, the one that a frame of this depth shows.
  std::optional<SeenSurface> shownAt(double px, double py, double depth) const;
  /// The same surface's place at another point of the picture.
  SeenSurface movedTo(SeenSurface seen, double px, double py) const;
  /// What a part of the range of depth is in blocks, so far from the eye: depth is 1 - near / distance.
  double stepAt(double distance, double depth) const { return depth * distance * distance / near_; }

 private:
  using Visit = std::function<bool(const SeenSurface&)>;
  glm::dvec3 eye() const { return camera_.position - glm::dvec3(scene_.origin); }
  double depthAt(const SeenSurface& seen, double px, double py) const;
  void forEachSurface(double px, double py, bool whole, const Visit& visit) const;
  PixelFootprint footprintOf(int x, int y, const glm::vec3& origin) const;

  const TraceScene& scene_;
  const TraceCamera& camera_;
  double near_;
  glm::dmat4 clipOf_;
  glm::dmat3 worldToView_;
};

}  // namespace orris
