#include "trace/voxel_grid.h"

#include <algorithm>
#include <cmath>

namespace orris {
namespace {

constexpr int kLongestLeap = 255;

/// Number of set bits of a set of six below each face.
struct FaceRanks {
  std::uint8_t rank[64][6];
};
constexpr FaceRanks makeFaceRanks() {
  FaceRanks ranks{};
  for (int mask = 0; mask < 64; ++mask) {
    std::uint8_t count = 0;
    for (int face = 0; face < 6; ++face) {
      ranks.rank[mask][face] = count;
      count = std::uint8_t(count + (mask >> face & 1));
    }
  }
  return ranks;
}
constexpr FaceRanks kFaceRanks = makeFaceRanks();

// FaceDirection of the side through which a ray enters, by axis and sign: x west east, y down up,
// z north south.
constexpr int kLowFace[3] = {4, 0, 2};

}  // namespace

/// Where a walk stands.
struct VoxelGrid::Steps {
  glm::vec3 inverse;
  glm::ivec3 cell;
  int axis = -1;  ///< through which the cell was entered, -1 for the first
  float enter = 0;
};

VoxelGrid::VoxelGrid(glm::ivec3 size, const std::vector<std::uint32_t>& offsets,
                     std::vector<TraceCell> cells, std::vector<TraceQuad> quads,
                     std::vector<TraceFilter> filters, TraceTexture texture)
    : size_(size),
      cellAt_(std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z), 0),
      cells_(std::move(cells)),
      quads_(std::move(quads)),
      filters_(std::move(filters)),
      texture_(std::move(texture)) {
  cells_.insert(cells_.begin(), TraceCell{});
  for (std::size_t i = 0; i < offsets.size(); ++i) cellAt_[offsets[i]] = std::uint32_t(i + 1);
  measureOpenCubes();
  floodFromOutside();
}

bool VoxelGrid::contains(glm::ivec3 cell) const {
  return cell.x >= 0 && cell.y >= 0 && cell.z >= 0 && cell.x < size_.x && cell.y < size_.y &&
         cell.z < size_.z;
}

// The largest empty cube with a corner in this cell is one larger than the smallest of those that
// begin in the seven cells next to it, as for the largest square in a bitmap.
void VoxelGrid::measureOpenCubes() {
  for (int octant = 0; octant < 8; ++octant) {
    std::vector<std::uint8_t>& cubes = openCubes_[std::size_t(octant)];
    cubes.assign(cellAt_.size(), 0);
    const glm::ivec3 step((octant & 1) != 0 ? 1 : -1, (octant & 2) != 0 ? 1 : -1,
                          (octant & 4) != 0 ? 1 : -1);
    const auto ordered = [&](int i, int axis) { return step[axis] > 0 ? size_[axis] - 1 - i : i; };
    for (int j = 0; j < size_.y; ++j) {
      for (int k = 0; k < size_.z; ++k) {
        for (int i = 0; i < size_.x; ++i) {
          const glm::ivec3 p(ordered(i, 0), ordered(j, 1), ordered(k, 2));
          if (cellAt_[offset(p)] != 0) continue;
          int smallest = kLongestLeap - 1;
          for (int n = 1; n < 8; ++n) {
            const glm::ivec3 q = p + step * glm::ivec3(n & 1, n >> 1 & 1, n >> 2);
            if (contains(q)) smallest = std::min(smallest, int(cubes[offset(q)]));
          }
          cubes[offset(p)] = std::uint8_t(smallest + 1);
        }
      }
    }
  }
}

void VoxelGrid::floodFromOutside() {
  open_.assign(cellAt_.size(), 0);
  std::vector<glm::ivec3> pending;
  const auto visit = [&](glm::ivec3 p) {
    if (!contains(p) || open_[offset(p)] != 0 || cells_[cellAt_[offset(p)]].cube) return;
    open_[offset(p)] = 1;
    pending.push_back(p);
  };
  for (int axis = 0; axis < 3; ++axis) {
    const int a = (axis + 1) % 3, b = (axis + 2) % 3;
    for (int i = 0; i < size_[a]; ++i) {
      for (int j = 0; j < size_[b]; ++j) {
        glm::ivec3 p(0);
        p[a] = i;
        p[b] = j;
        visit(p);
        p[axis] = size_[axis] - 1;
        visit(p);
      }
    }
  }
  while (!pending.empty()) {
    const glm::ivec3 p = pending.back();
    pending.pop_back();
    for (int axis = 0; axis < 3; ++axis) {
      glm::ivec3 step(0);
      step[axis] = 1;
      visit(p + step);
      visit(p - step);
    }
  }
}

bool VoxelGrid::enter(Ray& ray) const {
  if (size_.x == 0) return false;
  float enter = 0, leave = std::numeric_limits<float>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    const float low = -ray.origin[axis] / ray.direction[axis];
    const float high = (float(size_[axis]) - ray.origin[axis]) / ray.direction[axis];
    const float near = std::min(low, high);
    if (near > enter) {
      enter = near;
      ray.enteredBy = axis;
    }
    leave = std::min(leave, std::max(low, high));
  }
  if (enter >= leave) return false;
  ray.origin += ray.direction * enter;
  ray.cell = glm::clamp(glm::ivec3(glm::floor(ray.origin)), glm::ivec3(0), size_ - 1);
  return true;
}

template <bool kCamera>
void VoxelGrid::meetQuads(const TraceCell& cell, const Ray& ray, RayHit& hit) const {
  for (std::uint32_t i = cell.firstQuad; i < cell.firstQuad + cell.quadCount; ++i) {
    const TraceQuad& quad = quads_[i];
    const float slope = glm::dot(quad.normal, ray.direction);
    const float t = glm::dot(quad.normal, quad.corner - ray.origin) / slope;
    if (!(t > 1e-5f && t < hit.distance) || i == ray.ignore) continue;
    if (kCamera && slope > 0) continue;
    if (!kCamera && quad.translucent && (!quad.filters || slope > 0)) continue;
    const glm::vec3 point = ray.origin + ray.direction * t - quad.corner;
    const glm::vec2 at(glm::dot(point, quad.edgeU) / glm::dot(quad.edgeU, quad.edgeU),
                       glm::dot(point, quad.edgeV) / glm::dot(quad.edgeV, quad.edgeV));
    if (!(at.x >= 0 && at.x <= 1 && at.y >= 0 && at.y <= 1)) continue;
    if (quad.alphaTested && texel(quad, at).a < kAlphaTest) continue;
    if (!kCamera && quad.translucent) {
      hit.filter *= glm::vec3(texel(quad, at));
      continue;
    }
    hit.quad = i;
    hit.distance = t;
    hit.at = at;
    hit.back = slope > 0;
  }
}

/// What an occupied cell does; true: the walk ends here.
template <bool kCamera>
bool VoxelGrid::meet(const Ray& ray, const Steps& steps, RayHit& hit) const {
  const TraceCell& cell = cells_[cellAt_[offset(steps.cell)]];
  if (cell.cube) {
    if (steps.axis < 0) return false;
    const bool fromLow = ray.direction[steps.axis] > 0;
    const int face = kLowFace[steps.axis] + (fromLow ? 0 : 1);
    hit.cell = steps.cell;
    hit.cube = true;
    hit.back = false;
    hit.distance = steps.enter;
    const bool drawn = (cell.cubeFaces >> face & 1) != 0;
    hit.quad = drawn ? cell.firstQuad + kFaceRanks.rank[cell.cubeFaces][face] : kHiddenQuad;
    const TraceQuad& quad = quads_[hit.quad];
    const glm::vec3 point = ray.origin + ray.direction * steps.enter - quad.corner;
    hit.at =
        glm::clamp(glm::vec2(glm::dot(point, quad.edgeU), glm::dot(point, quad.edgeV)), 0.0f, 1.0f);
    return true;
  }
  meetQuads<kCamera>(cell, ray, hit);
  float leave = hit.distance;
  for (int axis = 0; axis < 3; ++axis) {
    const int side = steps.cell[axis] + (ray.direction[axis] > 0 ? 1 : 0);
    leave = std::min(leave, (float(side) - ray.origin[axis]) * steps.inverse[axis]);
  }
  if (!kCamera && cell.filter != 0) {
    const TraceFilter& filter = filters_[cell.filter];
    const float surface = (float(steps.cell.y) + filter.height - ray.origin.y) * steps.inverse.y;
    const bool rising = ray.direction.y > 0;
    const float from = rising ? steps.enter : std::max(steps.enter, surface);
    const float to = rising ? std::min(leave, surface) : leave;
    if (to > from) hit.filter *= glm::pow(filter.color, glm::vec3(to - from));
  }
  hit.cell = steps.cell;
  return hit.quad != kNoQuad;
}

template <bool kCamera>
RayHit VoxelGrid::walk(const Ray& ray) const {
  RayHit hit;
  Steps steps{1.0f / ray.direction, ray.cell, ray.enteredBy};
  const glm::bvec3 up = glm::greaterThan(ray.direction, glm::vec3(0));
  const std::uint8_t* cubes = openCubes_[std::size_t(up.x + 2 * up.y + 4 * up.z)].data();
  if (!contains(steps.cell)) return hit;
  for (;;) {
    int leap = cubes[offset(steps.cell)];
    if (leap == 0) {
      if (meet<kCamera>(ray, steps, hit)) return hit;
      leap = 1;
    }
    const glm::ivec3 low = steps.cell - (leap - 1) * glm::ivec3(!up.x, !up.y, !up.z);
    const glm::ivec3 high = steps.cell + (leap - 1) * glm::ivec3(up);
    const glm::vec3 planes = glm::vec3(low) + glm::vec3(leap) * glm::vec3(up);
    const glm::vec3 t = (planes - ray.origin) * steps.inverse;
    const int axis = t.x < t.y ? (t.x < t.z ? 0 : 2) : (t.y < t.z ? 1 : 2);
    steps.axis = axis;
    steps.enter = t[axis];
    // Truncation is floor here, as the grid begins at 0; the clamp keeps to the cube's own cells.
    const glm::ivec3 reached(ray.origin + ray.direction * t[axis]);
    steps.cell = glm::clamp(reached, low, high);
    steps.cell[axis] = up[axis] ? high[axis] + 1 : low[axis] - 1;
    if (!contains(steps.cell)) return hit;
  }
}

template RayHit VoxelGrid::walk<false>(const Ray&) const;
template RayHit VoxelGrid::walk<true>(const Ray&) const;

}  // namespace orris
