#include <orris/trace/grid/voxel_grid.h>

#include <algorithm>
#include <cmath>

namespace orris {
namespace {

// Squared, in texels: from here on the coarsest level is read, whatever the texture's size.
constexpr float kMostStep = 1e12f;

// Alpha tests of the sides of a cube need no search for the quad.
bool isHollow(const TraceCell& cell, const std::vector<TraceQuad>& quads) {
  if (cell.cube || cell.quadCount == 0 || cell.quadCount != kFaceRanks.rank[cell.faces][6])
    return false;
  const auto first = quads.begin() + cell.firstQuad;
  return std::all_of(first, first + cell.quadCount,
                     [](const TraceQuad& quad) { return quad.alphaTested && !quad.filters; });
}

/// 0 along an edge that has no length: places on kHiddenQuad are numbers, too.
glm::vec3 perLength(const glm::vec3& edge) {
  const float squared = glm::dot(edge, edge);
  return squared > 0 ? edge / squared : glm::vec3(0);
}

QuadPlane planeOf(const TraceQuad& quad) {
  QuadPlane plane;
  plane.normal = quad.normal;
  plane.offset = glm::dot(quad.normal, quad.corner);
  plane.alongU = perLength(quad.edgeU);
  plane.alongV = perLength(quad.edgeV);
  plane.startU = glm::dot(plane.alongU, quad.corner);
  plane.startV = glm::dot(plane.alongV, quad.corner);
  return plane;
}

/// Are the two one rectangle, seen from its two sides?
bool areTwins(const TraceQuad& a, const TraceQuad& b) {
  constexpr float kNear = 1e-4f;
  if (glm::dot(a.normal, b.normal) > -1 + kNear || a.alphaTested != b.alphaTested ||
      a.translucent != b.translucent)
    return false;
  const auto isCorner = [&](const glm::vec3& p) {
    for (const glm::vec3& offset : {glm::vec3(0), b.edgeU, b.edgeV, b.edgeU + b.edgeV})
      if (glm::distance(p, b.corner + offset) < kNear) return true;
    return false;
  };
  return isCorner(a.corner) && isCorner(a.corner + a.edgeU) && isCorner(a.corner + a.edgeV);
}

}  // namespace

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
  for (TraceCell& cell : cells_) {
    cell.hollow = isHollow(cell, quads_);
    // Most translucent quads stop no ray and tint none: the matter behind them does.
    const auto first = quads_.begin() + cell.firstQuad, end = first + cell.quadCount;
    cell.stops = std::any_of(
        first, end, [](const TraceQuad& quad) { return !quad.translucent || quad.filters; });
    if (!cell.cube && !cell.hollow) pairTwins(cell);
  }
  for (const TraceQuad& quad : quads_) planes_.push_back(planeOf(quad));
  boxes_ = measureOpenBoxes(size_, cellAt_);
  floodFromOutside();
}

// Surfaces of fluids, fire and plants are drawn as two quads in one place, one for each side.
void VoxelGrid::pairTwins(const TraceCell& cell) {
  for (std::uint32_t i = cell.firstQuad; i < cell.firstQuad + cell.quadCount; ++i)
    for (std::uint32_t j = i + 1; j < cell.firstQuad + cell.quadCount; ++j) {
      if (quads_[i].twin != kNoQuad || !areTwins(quads_[i], quads_[j])) continue;
      quads_[i].twin = j;
      quads_[j].twin = i;
    }
}

bool VoxelGrid::contains(glm::ivec3 cell) const {
  return cell.x >= 0 && cell.y >= 0 && cell.z >= 0 && cell.x < size_.x && cell.y < size_.y &&
         cell.z < size_.z;
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

glm::vec4 VoxelGrid::texel(const TraceQuad& quad, const glm::vec2& at,
                           const TextureLevel& level) const {
  const glm::vec2 place = quad.uvCorner + quad.uvU * at.x + quad.uvV * at.y;
  const glm::vec4 tint(quad.tint, 1);
  const glm::vec4& fine = texture_.at(place, level.level);
  if (level.next <= 0) return fine * tint;
  const glm::vec4& coarse = texture_.at(place, level.level + 1);
  const glm::vec4 stored(2.2f, 2.2f, 2.2f, 1);
  return glm::pow(
             glm::mix(glm::pow(fine, 1.0f / stored), glm::pow(coarse, 1.0f / stored), level.next),
             stored) *
         tint;
}

// As GL 4.5, section 8.14: log2 of the longer of the distances in texels to the pixel beside and to the one below.
// Mesa's software rasteriser takes the logarithm of the square by exponent and mantissa alone.
TextureLevel VoxelGrid::textureLevel(std::uint32_t quad, const PixelFootprint* footprint) const {
  if (footprint == nullptr) return {};
  const QuadPlane& plane = planes_[quad];
  std::array<glm::vec2, 3> texels;
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::vec3& ray = footprint->rays[i];
    const float t =
        (plane.offset - glm::dot(plane.normal, footprint->origin)) / glm::dot(plane.normal, ray);
    const glm::vec3 point = footprint->origin + ray * t;
    texels[i] = quads_[quad].uvU * (glm::dot(point, plane.alongU) - plane.startU) +
                quads_[quad].uvV * (glm::dot(point, plane.alongV) - plane.startV);
  }
  const glm::vec2 across = texels[1] - texels[0], down = texels[2] - texels[0];
  const float wide = glm::dot(across, across), high = glm::dot(down, down);
  // A ray along the quad's plane (a level camera's middle row) never meets it: its place is no number, and GL's step endless.
  if (!(wide < kMostStep && high < kMostStep)) return {TraceTexture::kLevels - 1, 0};
  int power = 0;
  const float mantissa = 2 * std::frexp(std::max(wide, high), &power);
  const float level = 0.5f * (float(power - 1) + mantissa - 1);
  if (level <= 0) return {};
  const int lower = std::min(int(level), TraceTexture::kLevels - 1);
  return {lower, lower < TraceTexture::kLevels - 1 ? level - float(lower) : 0};
}

}  // namespace orris
