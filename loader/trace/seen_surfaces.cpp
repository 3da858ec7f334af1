#include <orris/trace/seen_surfaces.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace orris {
namespace {

glm::dvec3 rayOf(const TraceCamera& camera, double x, double y) {
  const glm::dvec4 clip = glm::dmat4(camera.projectionInverse) *
                          glm::dvec4(2 * x / camera.width - 1, 1 - 2 * y / camera.height, 1, 1);
  return glm::normalize(glm::dmat3(camera.modelViewInverse) * (glm::dvec3(clip) / clip.w));
}

SeenSurface seen(const TraceQuad& quad, const glm::dvec3& eye, const glm::dvec3& direction) {
  SeenSurface result;
  result.quad = &quad;
  result.normal = glm::dvec3(quad.normal);
  const double slope = glm::dot(direction, result.normal);
  const double distance = glm::dot(glm::dvec3(quad.corner) - eye, result.normal) / slope;
  result.position = eye + direction * distance;
  if (slope > 0) result.normal = -result.normal;
  return result;
}

}  // namespace

SeenSurfaces::SeenSurfaces(const TraceScene& scene, const TraceCamera& camera)
    : scene_(scene),
      camera_(camera),
      clipOf_(glm::inverse(glm::dmat4(camera.projectionInverse))),
      worldToView_(glm::transpose(glm::dmat3(camera.modelViewInverse))) {
  const glm::dvec4 corner = glm::dmat4(camera.projectionInverse) * glm::dvec4(0, 0, -1, 1);
  near_ = -corner.z / corner.w;
}

std::vector<SeenSurface> SeenSurfaces::at(double px, double py, double depth) const {
  std::vector<SeenSurface> found;
  double last = std::numeric_limits<double>::infinity();
  forEachSurface(px, py, false, [&](const SeenSurface& next) {
    const double distance = glm::distance(eye(), next.position);
    if (found.empty()) last = distance + stepAt(distance, depth);
    if (distance > last) return false;
    found.push_back(next);
    return depth != 0;
  });
  return found;
}

std::optional<SeenSurface> SeenSurfaces::shownAt(double px, double py, double depth) const {
  if (depth >= 1) return SeenSurface();
  std::optional<SeenSurface> shown;
  double least = std::numeric_limits<double>::infinity();
  forEachSurface(px, py, true, [&](const SeenSurface& next) {
    const double here = depthAt(next, px, py), off = std::abs(here - depth);
    const double unsure = kFrameDepth + std::abs(depthAt(next, px + kFramePixel, py) - here) +
                          std::abs(depthAt(next, px, py + kFramePixel) - here);
    if (off < least && off <= unsure) {
      least = off;
      shown = next;
    }
    return true;
  });
  return shown;
}

SeenSurface SeenSurfaces::movedTo(SeenSurface seen, double px, double py) const {
  const glm::dvec3 direction = rayOf(camera_, px, py);
  const double distance =
      glm::dot(seen.position - eye(), seen.normal) / glm::dot(direction, seen.normal);
  seen.position = eye() + direction * distance;
  return seen;
}

/// Depth of the surface's plane at a point of the picture, 0 to 1.
double SeenSurfaces::depthAt(const SeenSurface& seen, double px, double py) const {
  const glm::dvec4 clip =
      clipOf_ * glm::dvec4(glm::dmat3(worldToView_) * (movedTo(seen, px, py).position - eye()), 1);
  return clip.z / clip.w * 0.5 + 0.5;
}

/// Opaque surfaces along a ray until `visit` returns false; `whole`: cutouts without holes.
void SeenSurfaces::forEachSurface(double px, double py, bool whole, const Visit& visit) const {
  const glm::dvec3 direction = rayOf(camera_, px, py);
  Ray ray;
  ray.origin = glm::vec3(eye());
  ray.direction = withoutZeros(glm::vec3(direction));
  ray.cell = glm::ivec3(glm::floor(ray.origin));
  PixelFootprint footprint = footprintOf(std::min(int(px), camera_.width - 1),
                                         std::min(int(py), camera_.height - 1), ray.origin);
  footprint.whole = whole;
  if (!scene_.grid.contains(ray.cell) && !scene_.grid.enter(ray)) return;
  for (int layer = 0; layer < kMostLayers; ++layer) {
    const RayHit hit = scene_.grid.look(ray, &footprint);
    if (hit.quad == kNoQuad) return;
    const TraceQuad& quad = scene_.grid.quad(hit.quad);
    if (!quad.blended) {
      const SeenSurface next = seen(quad, eye(), direction);
      // What has no plane fills the inside of a solid.
      if (std::isnan(glm::distance(eye(), next.position)) || !visit(next)) return;
    }
    ray.origin = quad.corner + quad.edgeU * hit.at.x + quad.edgeV * hit.at.y;
    ray.cell = hit.cell;
    ray.enteredBy = -1;
    ray.ignore = hit.quad;
  }
}

// Squares of four begin in the lower left corner of the picture.
PixelFootprint SeenSurfaces::footprintOf(int x, int y, const glm::vec3& origin) const {
  const int left = x & ~1, below = camera_.height - 1 - ((camera_.height - 1 - y) & ~1);
  const auto ray = [&](int px, int py) { return glm::vec3(rayOf(camera_, px + 0.5, py + 0.5)); };
  return {origin, {ray(left, below), ray(left + 1, below), ray(left, below - 1)}};
}

}  // namespace orris
