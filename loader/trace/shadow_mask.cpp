#include "trace/shadow_mask.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace orris {
namespace {

/// Rays begin this far before what the pixel shows, blocks.
constexpr double kLift = 1e-5;
constexpr int kMaxLayers = 64;

/// Is a point of the quad's plane on the quad? Rays through an edge meet both its faces.
bool covers(const glm::dvec3 (&corners)[4], const glm::dvec3& normal, const glm::dvec3& point) {
  constexpr double kEdge = 1e-9;
  for (int i = 0; i < 4; ++i) {
    const glm::dvec3 edge = corners[(i + 1) % 4] - corners[i];
    if (glm::dot(glm::cross(edge, point - corners[i]), normal) < -kEdge) return false;
  }
  return true;
}

glm::dvec3 rayOf(const TraceCamera& camera, double x, double y) {
  const glm::dvec4 clip = glm::dmat4(camera.projectionInverse) *
                          glm::dvec4(2 * x / camera.width - 1, 1 - 2 * y / camera.height, 1, 1);
  return glm::normalize(glm::dmat3(camera.modelViewInverse) * (glm::dvec3(clip) / clip.w));
}

/// What a pixel shows of opaque blocks, as the path tracer finds it.
struct Seen {
  const TraceQuad* quad = nullptr;    ///< nullptr: the sky
  glm::dvec3 position{0}, normal{0};  ///< grid space; normal toward the eye
};

class Viewer {
 public:
  Viewer(const TraceScene& scene, const TraceCamera& camera) : scene_(scene), camera_(camera) {
    const glm::dvec4 corner = glm::dmat4(camera.projectionInverse) * glm::dvec4(0, 0, -1, 1);
    near_ = -corner.z / corner.w;
    clipOf_ = glm::inverse(glm::dmat4(camera.projectionInverse));
    worldToView_ = glm::transpose(glm::dmat3(camera.modelViewInverse));
  }

  /// The first opaque surface, and those that follow so close that a frame may show them instead.
  /// `px`, `py` in the pixel, or on its rim: (0, 0) is the picture's top left corner. `depth`: part of
  /// the range of depth.
  std::vector<Seen> at(double px, double py, double depth) const {
    std::vector<Seen> found;
    double last = std::numeric_limits<double>::infinity();
    forEachSurface(px, py, false, [&](const Seen& next) {
      const double distance = glm::distance(eye(), next.position);
      if (found.empty()) last = distance + stepAt(distance, depth);
      if (distance > last) return false;
      found.push_back(next);
      return depth != 0;
    });
    return found;
  }

  /// Of all surfaces that the ray meets, holes or not, the one that a frame of this depth shows.
  std::optional<Seen> shownAt(double px, double py, double depth) const {
    if (depth >= 1) return Seen();
    std::optional<Seen> shown;
    double least = std::numeric_limits<double>::infinity();
    forEachSurface(px, py, true, [&](const Seen& next) {
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

  /// The same surface's place at another point of the picture.
  Seen movedTo(Seen seen, double px, double py) const {
    const glm::dvec3 direction = rayOf(camera_, px, py);
    const double distance =
        glm::dot(seen.position - eye(), seen.normal) / glm::dot(direction, seen.normal);
    seen.position = eye() + direction * distance;
    return seen;
  }

  /// What a part of the range of depth is in blocks, so far from the eye: depth is 1 - near / distance.
  double stepAt(double distance, double depth) const { return depth * distance * distance / near_; }

 private:
  glm::dvec3 eye() const { return camera_.position - glm::dvec3(scene_.origin); }

  /// Depth of the surface's plane at a point of the picture, 0 to 1.
  double depthAt(const Seen& seen, double px, double py) const {
    const glm::dvec4 clip =
        clipOf_ *
        glm::dvec4(glm::dmat3(worldToView_) * (movedTo(seen, px, py).position - eye()), 1);
    return clip.z / clip.w * 0.5 + 0.5;
  }

  /// Opaque surfaces along a ray until `visit` returns false; `whole`: cutouts without holes.
  template <class Visit>
  void forEachSurface(double px, double py, bool whole, const Visit& visit) const {
    const glm::dvec3 direction = rayOf(camera_, px, py);
    Ray ray;
    ray.origin = glm::vec3(eye());
    ray.direction = withoutZeros(glm::vec3(direction));
    ray.cell = glm::ivec3(glm::floor(ray.origin));
    PixelFootprint footprint = footprintOf(std::min(int(px), camera_.width - 1),
                                           std::min(int(py), camera_.height - 1), ray.origin);
    footprint.whole = whole;
    if (!scene_.grid.contains(ray.cell) && !scene_.grid.enter(ray)) return;
    for (int layer = 0; layer < kMaxLayers; ++layer) {
      const RayHit hit = scene_.grid.look(ray, &footprint);
      if (hit.quad == kNoQuad) return;
      const TraceQuad& quad = scene_.grid.quad(hit.quad);
      if (!quad.translucent) {
        const Seen next = seen(quad, eye(), direction);
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
  PixelFootprint footprintOf(int x, int y, const glm::vec3& origin) const {
    const int left = x & ~1, below = camera_.height - 1 - ((camera_.height - 1 - y) & ~1);
    const auto ray = [&](int px, int py) { return glm::vec3(rayOf(camera_, px + 0.5, py + 0.5)); };
    return {origin, {ray(left, below), ray(left + 1, below), ray(left, below - 1)}};
  }

  static Seen seen(const TraceQuad& quad, const glm::dvec3& eye, const glm::dvec3& direction) {
    Seen result;
    result.quad = &quad;
    result.normal = glm::dvec3(quad.normal);
    const double slope = glm::dot(direction, result.normal);
    const double distance = glm::dot(glm::dvec3(quad.corner) - eye, result.normal) / slope;
    result.position = eye + direction * distance;
    if (slope > 0) result.normal = -result.normal;
    return result;
  }

  const TraceScene& scene_;
  const TraceCamera& camera_;
  double near_;
  glm::dmat4 clipOf_;
  glm::dmat3 worldToView_;
};

}  // namespace

CasterRays::CasterRays(const CasterSet& casters)
    : low_(std::numeric_limits<double>::max()), high_(std::numeric_limits<double>::lowest()) {
  constexpr double kReach = 0.01;  // faces on a cell's side belong to both cells
  for (const CasterFace& face : casters.faces) {
    Quad quad;
    glm::dvec3 low(std::numeric_limits<double>::max()), high(std::numeric_limits<double>::lowest());
    for (int i = 0; i < 4; ++i) {
      quad.corners[i] = glm::dvec3(face.corners[std::size_t(i)]) + glm::dvec3(casters.origin);
      low = glm::min(low, quad.corners[i]);
      high = glm::max(high, quad.corners[i]);
    }
    quad.normal = glm::dvec3(face.normal);
    low_ = glm::min(low_, low);
    high_ = glm::max(high_, high);
    const glm::ivec3 first(glm::floor(low - kReach)), last(glm::floor(high + kReach));
    for (int y = first.y; y <= last.y; ++y)
      for (int z = first.z; z <= last.z; ++z)
        for (int x = first.x; x <= last.x; ++x)
          byCell_[keyOf({x, y, z})].push_back(std::uint32_t(quads_.size()));
    quads_.push_back(quad);
  }
}

std::uint64_t CasterRays::keyOf(const glm::ivec3& cell) {
  constexpr int kBits = 21;
  std::uint64_t key = 0;
  for (int axis = 0; axis < 3; ++axis)
    key = key << kBits | (std::uint64_t(std::uint32_t(cell[axis])) & ((1u << kBits) - 1));
  return key;
}

bool CasterRays::blockedIn(const glm::ivec3& cell, const glm::dvec3& from, const glm::dvec3& way,
                           double end) const {
  const auto found = byCell_.find(keyOf(cell));
  if (found == byCell_.end()) return false;
  return std::any_of(found->second.begin(), found->second.end(), [&](std::uint32_t index) {
    const Quad& quad = quads_[index];
    const double slope = glm::dot(way, quad.normal);
    if (std::abs(slope) < 1e-12) return false;
    const double t = glm::dot(quad.corners[0] - from, quad.normal) / slope;
    return t > 0 && t < end && covers(quad.corners, quad.normal, from + way * t);
  });
}

bool CasterRays::blocked(const glm::dvec3& from, const glm::dvec4& toward) const {
  glm::dvec3 way = glm::dvec3(toward) - toward.w * from;
  const double end = toward.w == 0 ? std::numeric_limits<double>::infinity() : glm::length(way);
  way = glm::normalize(way);
  glm::ivec3 cell(glm::floor(from));
  glm::dvec3 next(std::numeric_limits<double>::infinity()), step = next;
  for (int axis = 0; axis < 3; ++axis) {
    if (way[axis] == 0) continue;
    step[axis] = 1 / std::abs(way[axis]);
    next[axis] =
        (way[axis] > 0 ? cell[axis] + 1 - from[axis] : from[axis] - cell[axis]) * step[axis];
  }
  for (double t = 0; t < end;) {
    if (blockedIn(cell, from, way, end)) return true;
    const int axis = next.x < next.y ? (next.x < next.z ? 0 : 2) : (next.y < next.z ? 1 : 2);
    t = next[axis];
    next[axis] += step[axis];
    cell[axis] += way[axis] > 0 ? 1 : -1;
    // Past the last caster in this direction nothing follows.
    if (way[axis] > 0 ? cell[axis] > high_[axis] : cell[axis] + 1 < low_[axis]) return false;
  }
  return false;
}

namespace {

/// Whether light reaches what is seen through points of the picture.
class LightSeen {
 public:
  LightSeen(const TraceScene& scene, const TraceCamera& camera, const CasterRays& casters,
            const glm::dvec4& light)
      : scene_(scene), camera_(camera), viewer_(scene, camera), casters_(casters), light_(light) {}

  bool at(double x, double y) const {
    const std::vector<Seen> seen = viewer_.at(x, y, 0);
    return seen.empty() || reaches(seen[0], 0);
  }

  /// What a frame shows at a pixel's middle when the ray meets another surface first.
  std::optional<Seen> other(double x, double y, double depth) const {
    std::vector<Seen> met = viewer_.at(x, y, kFrameDepth);
    if (met.empty()) met.emplace_back();
    const std::optional<Seen> shown = viewer_.shownAt(x, y, depth);
    const bool same = !shown || std::any_of(met.begin(), met.end(), [&](const Seen& seen) {
      return seen.quad == shown->quad;
    });
    return same ? std::nullopt : shown;
  }

  bool reached(const Seen& seen) const { return seen.quad == nullptr || reaches(seen, 0); }

  /// doubtful() of one surface.
  bool doubtfulOn(const Seen& seen, double x, double y) const {
    bool lit = false, dark = false;
    for (const glm::dvec2& place : kPlaces) {
      const Seen moved =
          viewer_.movedTo(seen, x + place.x * kFramePixel, y + place.y * kFramePixel);
      for (const double lift : {0.0, kFrameDepth}) (reaches(moved, lift) ? lit : dark) = true;
    }
    return lit && dark;
  }

  /// Does the answer at a pixel's middle depend on more than a frame knows? Any straight line within
  /// half of kFramePixel parts one of three points from the middle.
  bool doubtful(double x, double y) const {
    bool lit = false, dark = false;
    for (const glm::dvec2& place : kPlaces) {
      const auto found =
          viewer_.at(x + place.x * kFramePixel, y + place.y * kFramePixel, kFrameDepth);
      lit |= found.empty();
      for (const Seen& seen : found)
        for (const double lift : {0.0, kFrameDepth}) (reaches(seen, lift) ? lit : dark) = true;
      if (lit && dark) return true;
    }
    return false;
  }

 private:
  static constexpr glm::dvec2 kPlaces[] = {{0, 0}, {0.97, 0.26}, {-0.71, 0.71}, {-0.26, -0.97}};

  /// `lift`: of the range of depth, from the seen place to the eye.
  bool reaches(const Seen& seen, double lift) const {
    const glm::dvec3 on = seen.position + glm::dvec3(scene_.origin);
    const double cosine = glm::dot(seen.normal, glm::normalize(glm::dvec3(light_) - light_.w * on));
    if ((seen.quad->thin ? std::abs(cosine) : cosine) <= kGrazing) return false;
    const glm::dvec3 toEye = camera_.position - on;
    const double distance = glm::length(toEye);
    const glm::dvec3 at = on + toEye * (viewer_.stepAt(distance, lift) / distance);
    return !casters_.blocked(at + seen.normal * kLift, light_);
  }

  const TraceScene& scene_;
  const TraceCamera& camera_;
  Viewer viewer_;
  const CasterRays& casters_;
  glm::dvec4 light_;
};

}  // namespace

ImageF shadowMask(const TraceScene& scene, const TraceCamera& camera, const CasterRays& casters,
                  const glm::dvec4& light, ShownFrame* shown) {
  const LightSeen seen(scene, camera, casters, light);
  const auto row = [&](double y, double first) {
    std::vector<bool> lit;
    for (int x = 0; x + first <= camera.width; ++x) lit.push_back(seen.at(x + first, y));
    return lit;
  };
  ImageF mask(camera.width, camera.height, 1);
  std::vector<bool> above = row(0, 0);
  for (int y = 0; y < camera.height; ++y) {
    const std::vector<bool> middle = row(y + 0.5, 0.5), below = row(y + 1, 0);
    for (std::size_t x = 0; x < middle.size(); ++x) {
      const int corners = above[x] + above[x + 1] + below[x] + below[x + 1];
      const double px = double(x) + 0.5, py = y + 0.5;
      bool changes = corners != (middle[x] ? 4 : 0) || seen.doubtful(px, py), lit = middle[x];
      const std::optional<Seen> other =
          shown != nullptr ? seen.other(px, py, shown->depth.at(int(x), y)[0]) : std::nullopt;
      if (other) {
        ++shown->others;
        lit = seen.reached(*other);
        changes = changes || (other->quad != nullptr && seen.doubtfulOn(*other, px, py));
      }
      mask.at(int(x), y)[0] = lit ? (changes ? 0.75f : 1.0f) : (changes ? 0.25f : 0.0f);
    }
    above = below;
  }
  return mask;
}

}  // namespace orris
