#include <orris/trace/shadow_mask.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <orris/trace/seen_surfaces.h>

namespace orris {
namespace {

/// Rays begin this far before what the pixel shows, blocks.
constexpr double kLift = 1e-5;

/// Is a point of the quad's plane on the quad? Rays through an edge meet both its faces.
bool covers(const glm::dvec3 (&corners)[4], const glm::dvec3& normal, const glm::dvec3& point) {
  constexpr double kEdge = 1e-9;
  for (int i = 0; i < 4; ++i) {
    const glm::dvec3 edge = corners[(i + 1) % 4] - corners[i];
    if (glm::dot(glm::cross(edge, point - corners[i]), normal) < -kEdge) return false;
  }
  return true;
}

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

bool CasterRays::blockedIn(const glm::ivec3& cell, const glm::dvec3& from,
                           const glm::dvec3& direction, double end) const {
  const auto found = byCell_.find(keyOf(cell));
  if (found == byCell_.end()) return false;
  return std::any_of(found->second.begin(), found->second.end(), [&](std::uint32_t index) {
    const Quad& quad = quads_[index];
    const double slope = glm::dot(direction, quad.normal);
    if (std::abs(slope) < 1e-12) return false;
    const double t = glm::dot(quad.corners[0] - from, quad.normal) / slope;
    return t > 0 && t < end && covers(quad.corners, quad.normal, from + direction * t);
  });
}

bool CasterRays::blocked(const glm::dvec3& from, const glm::dvec4& toward) const {
  glm::dvec3 direction = glm::dvec3(toward) - toward.w * from;
  const double end =
      toward.w == 0 ? std::numeric_limits<double>::infinity() : glm::length(direction);
  direction = glm::normalize(direction);
  glm::ivec3 cell(glm::floor(from));
  glm::dvec3 next(std::numeric_limits<double>::infinity()), step = next;
  for (int axis = 0; axis < 3; ++axis) {
    if (direction[axis] == 0) continue;
    step[axis] = 1 / std::abs(direction[axis]);
    next[axis] =
        (direction[axis] > 0 ? cell[axis] + 1 - from[axis] : from[axis] - cell[axis]) * step[axis];
  }
  for (double t = 0; t < end;) {
    if (blockedIn(cell, from, direction, end)) return true;
    const int axis = next.x < next.y ? (next.x < next.z ? 0 : 2) : (next.y < next.z ? 1 : 2);
    t = next[axis];
    next[axis] += step[axis];
    cell[axis] += direction[axis] > 0 ? 1 : -1;
    // Past the last caster in this direction nothing follows.
    if (direction[axis] > 0 ? cell[axis] > high_[axis] : cell[axis] + 1 < low_[axis]) return false;
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
    const std::vector<SeenSurface> seen = viewer_.at(x, y, 0);
    return seen.empty() || reaches(seen[0], 0);
  }

  /// What a frame shows at a pixel's middle when the ray meets another surface first.
  std::optional<SeenSurface> other(double x, double y, double depth) const {
    std::vector<SeenSurface> met = viewer_.at(x, y, kFrameDepth);
    if (met.empty()) met.emplace_back();
    const std::optional<SeenSurface> shown = viewer_.shownAt(x, y, depth);
    const bool same = !shown || std::any_of(met.begin(), met.end(), [&](const SeenSurface& seen) {
      return seen.quad == shown->quad;
    });
    return same ? std::nullopt : shown;
  }

  bool reached(const SeenSurface& seen) const { return seen.quad == nullptr || reaches(seen, 0); }

  /// doubtful() of one surface.
  bool doubtfulOn(const SeenSurface& seen, double x, double y) const {
    bool lit = false, dark = false;
    for (const glm::dvec2& place : kPlaces) {
      const SeenSurface moved =
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
      for (const SeenSurface& seen : found)
        for (const double lift : {0.0, kFrameDepth}) (reaches(seen, lift) ? lit : dark) = true;
      if (lit && dark) return true;
    }
    return false;
  }

 private:
  static constexpr glm::dvec2 kPlaces[] = {{0, 0}, {0.97, 0.26}, {-0.71, 0.71}, {-0.26, -0.97}};

  /// `lift`: of the range of depth, from the seen place to the eye.
  bool reaches(const SeenSurface& seen, double lift) const {
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
  SeenSurfaces viewer_;
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
      const std::optional<SeenSurface> other =
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
