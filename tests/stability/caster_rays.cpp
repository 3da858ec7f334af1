#include "caster_rays.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace orris::test {
namespace {

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

LightStopped CasterRays::stopping() const {
  return [this](const TraceQuad&, const glm::dvec3& from, const glm::dvec4& light) {
    return blocked(from, light);
  };
}

}  // namespace orris::test
