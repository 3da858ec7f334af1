// The hot loop of the path tracer.
#include <algorithm>
#include <cmath>

#include <orris/trace/grid/voxel_grid.h>

namespace orris {
namespace {

// FaceDirection of the side through which a ray enters, by axis and sign: x west east, y down up,
// z north south.
constexpr int kLowFace[3] = {4, 0, 2};
// Two sheets in one place are one: what a ray has just left does not stop it.
constexpr float kNearest = 1e-5f;

}  // namespace

/// One ray on its way. Written out by axis, and without branches on which axis comes next, as no
/// processor can foretell them.
template <bool kCamera>
class VoxelGrid::Walk {
 public:
  Walk(const VoxelGrid& grid, const Ray& ray, RayHit& hit,
       const PixelFootprint* footprint = nullptr)
      : grid_(grid),
        ray_(ray),
        hit_(hit),
        footprint_(footprint),
        inverse_(1.0f / ray.direction),
        axis_(ray.enteredBy) {
    for (int axis = 0; axis < 3; ++axis) {
      up_[axis] = ray.direction[axis] > 0;
      step_[axis] = 2 * up_[axis] - 1;
    }
    x_ = ray.cell.x;
    y_ = ray.cell.y;
    z_ = ray.cell.z;
    boxes_ = grid.boxes_[std::size_t(up_[0] + 2 * up_[1] + 4 * up_[2])].data();
  }

  bool isInside() const {
    return (unsigned(x_) < unsigned(grid_.size_.x)) & (unsigned(y_) < unsigned(grid_.size_.y)) &
           (unsigned(z_) < unsigned(grid_.size_.z));
  }

  /// One leap; false: the ray has met something, left the grid or gone far enough. Two walks in one function would call it.
  [[gnu::always_inline]] inline bool advance() {
    unsigned box = boxes_[grid_.offset({x_, y_, z_})];
    if (box == 0) {
      if (meet()) return false;
      box = packBox(1, 1, 1);
    }
    const int outX = x_ + step_[0] * boxX(box), outY = y_ + step_[1] * boxY(box),
              outZ = z_ + step_[2] * boxZ(box);
    const glm::vec3& o = ray_.origin;
    const glm::vec3& d = ray_.direction;
    const float tx = (float(outX + 1 - up_[0]) - o.x) * inverse_.x;
    const float ty = (float(outY + 1 - up_[1]) - o.y) * inverse_.y;
    const float tz = (float(outZ + 1 - up_[2]) - o.z) * inverse_.z;
    const float t = std::min(tx, std::min(ty, tz));
    const bool byX = tx == t, byY = !byX && ty == t, byZ = !byX && !byY;
    // Truncation is floor here, as the grid begins at 0; the clamp keeps to the box's own cells.
    const auto within = [](float place, int from, int out, int step) {
      const int last = out - step;
      return std::clamp(int(place), std::min(from, last), std::max(from, last));
    };
    const int nextX = within(o.x + d.x * t, x_, outX, step_[0]);
    const int nextY = within(o.y + d.y * t, y_, outY, step_[1]);
    const int nextZ = within(o.z + d.z * t, z_, outZ, step_[2]);
    x_ = byX ? outX : nextX;
    y_ = byY ? outY : nextY;
    z_ = byZ ? outZ : nextZ;
    axis_ = byX ? 0 : byY ? 1 : 2;
    enter_ = t;
    return isInside() & (t < hit_.distance);
  }

  /// After the last leap.
  void finish() {
    if (!kCamera && depth_ != glm::vec3(0)) hit_.filter *= glm::exp(depth_);
  }

 private:
  [[gnu::always_inline]] inline bool meet();
  [[gnu::always_inline]] inline bool meetCube(const TraceCell& cell);
  [[gnu::noinline]] bool meetPart(const TraceCell& cell);
  bool meetSide(const TraceCell& cell, int face, float t, bool back);
  void meetSheets(const TraceCell& cell);
  void meetQuads(const TraceCell& cell);
  void passFilter(const TraceFilter& filter, float leave);
  bool isHole(std::uint32_t quad, const glm::vec2& at) const {
    if (kCamera && footprint_ != nullptr && footprint_->whole) return false;
    const TraceQuad& sheet = grid_.quads_[quad];
    const glm::vec4 texel = kCamera ? grid_.texel(sheet, at, grid_.textureLevel(quad, footprint_))
                                    : grid_.texel(sheet, at);
    return texel.a < kAlphaTest;
  }
  /// When and through which axis the ray leaves the cell.
  std::pair<float, int> leaving() const;

  const VoxelGrid& grid_;
  const Ray& ray_;
  RayHit& hit_;
  const PixelFootprint* footprint_;
  glm::vec3 inverse_;
  glm::vec3 depth_{0};  ///< logarithm of what filters let through
  const std::uint16_t* boxes_;
  int up_[3], step_[3];
  int x_, y_, z_;
  int axis_;  ///< through which the cell was entered, -1 for the first
  float enter_ = 0;
};

template <bool kCamera>
bool VoxelGrid::Walk<kCamera>::meet() {
  const TraceCell& cell = grid_.cells_[grid_.cellAt_[grid_.offset({x_, y_, z_})]];
  return cell.cube ? meetCube(cell) : meetPart(cell);
}

template <bool kCamera>
bool VoxelGrid::Walk<kCamera>::meetPart(const TraceCell& cell) {
  hit_.cell = {x_, y_, z_};
  if (cell.hollow)
    meetSheets(cell);
  else if (kCamera || cell.stops)
    meetQuads(cell);
  if (!kCamera && cell.filter != 0)
    passFilter(grid_.filters_[cell.filter], std::min(leaving().first, hit_.distance));
  return hit_.quad != kNoQuad;
}

template <bool kCamera>
bool VoxelGrid::Walk<kCamera>::meetCube(const TraceCell& cell) {
  if (axis_ < 0) return false;
  const int face = kLowFace[axis_] + 1 - up_[axis_];
  const bool drawn = (cell.faces >> face & 1) != 0;
  hit_.cell = {x_, y_, z_};
  hit_.cube = true;
  hit_.distance = enter_;
  hit_.quad = drawn ? cell.firstQuad + kFaceRanks.rank[cell.faces][face] : kHiddenQuad;
  const QuadPlane& plane = grid_.planes_[hit_.quad];
  const glm::vec3 point = ray_.origin + ray_.direction * enter_;
  hit_.at = glm::clamp(glm::vec2(glm::dot(point, plane.alongU) - plane.startU,
                                 glm::dot(point, plane.alongV) - plane.startV),
                       0.0f, 1.0f);
  return true;
}

template <bool kCamera>
std::pair<float, int> VoxelGrid::Walk<kCamera>::leaving() const {
  const float tx = (float(x_ + up_[0]) - ray_.origin.x) * inverse_.x;
  const float ty = (float(y_ + up_[1]) - ray_.origin.y) * inverse_.y;
  const float tz = (float(z_ + up_[2]) - ray_.origin.z) * inverse_.z;
  if (tx < ty) return tx < tz ? std::pair(tx, 0) : std::pair(tz, 2);
  return ty < tz ? std::pair(ty, 1) : std::pair(tz, 2);
}

/// The side of a cube with holes: does it stop the ray?
template <bool kCamera>
bool VoxelGrid::Walk<kCamera>::meetSide(const TraceCell& cell, int face, float t, bool back) {
  if ((cell.faces >> face & 1) == 0) return false;
  const std::uint32_t index = cell.firstQuad + kFaceRanks.rank[cell.faces][face];
  if (index == ray_.ignore || !(t > kNearest)) return false;
  const QuadPlane& plane = grid_.planes_[index];
  const glm::vec3 point = ray_.origin + ray_.direction * t;
  const glm::vec2 at = glm::clamp(glm::vec2(glm::dot(point, plane.alongU) - plane.startU,
                                            glm::dot(point, plane.alongV) - plane.startV),
                                  0.0f, 1.0f);
  if (isHole(index, at)) return false;
  hit_.quad = index;
  hit_.distance = t;
  hit_.at = at;
  hit_.back = back;
  return true;
}

template <bool kCamera>
void VoxelGrid::Walk<kCamera>::meetSheets(const TraceCell& cell) {
  if (axis_ >= 0 && meetSide(cell, kLowFace[axis_] + 1 - up_[axis_], enter_, false)) return;
  if (kCamera) return;
  const auto [leave, axis] = leaving();
  meetSide(cell, kLowFace[axis] + up_[axis], leave, true);
}

template <bool kCamera>
void VoxelGrid::Walk<kCamera>::meetQuads(const TraceCell& cell) {
  for (std::uint32_t i = cell.firstQuad; i < cell.firstQuad + cell.quadCount; ++i) {
    const QuadPlane& plane = grid_.planes_[i];
    const float slope = glm::dot(plane.normal, ray_.direction);
    if (kCamera && slope > 0) continue;
    const float t = (plane.offset - glm::dot(plane.normal, ray_.origin)) / slope;
    if (!(t > kNearest && t < hit_.distance) || i == ray_.ignore) continue;
    const glm::vec3 point = ray_.origin + ray_.direction * t;
    const glm::vec2 at(glm::dot(point, plane.alongU) - plane.startU,
                       glm::dot(point, plane.alongV) - plane.startV);
    if (!(at.x >= 0 && at.x <= 1 && at.y >= 0 && at.y <= 1)) continue;
    const TraceQuad& quad = grid_.quads_[i];
    // Of two quads in one place a ray meets the front; what left either leaves both.
    if (quad.twin != kNoQuad && (slope > 0 || quad.twin == ray_.ignore)) continue;
    if (!kCamera && quad.translucent) {
      if (quad.filters && slope < 0)
        depth_ += glm::log(glm::max(glm::vec3(grid_.texel(quad, at)), 1e-6f));
      continue;
    }
    if (quad.alphaTested && isHole(i, at)) continue;
    hit_.quad = i;
    hit_.distance = t;
    hit_.at = at;
    hit_.back = slope > 0;
  }
}

template <bool kCamera>
void VoxelGrid::Walk<kCamera>::passFilter(const TraceFilter& filter, float leave) {
  const float surface = (float(y_) + filter.height - ray_.origin.y) * inverse_.y;
  const float from = up_[1] ? enter_ : std::max(enter_, surface);
  const float to = up_[1] ? std::min(leave, surface) : leave;
  if (to > from) depth_ += filter.logarithm * (to - from);
}

RayHit VoxelGrid::intersect(const Ray& ray) const {
  RayHit hit;
  intersect(ray, hit);
  return hit;
}

void VoxelGrid::intersect(const Ray& ray, RayHit& hit) const {
  Walk<false> walk(*this, ray, hit);
  bool going = walk.isInside();
  while (going) going = walk.advance();
  walk.finish();
}

RayHit VoxelGrid::look(const Ray& ray, const PixelFootprint* footprint) const {
  RayHit hit;
  Walk<true> walk(*this, ray, hit, footprint);
  bool going = walk.isInside();
  while (going) going = walk.advance();
  return hit;
}

// Leaps of one ray wait for each other, those of two do not.
void VoxelGrid::intersect(const Ray& first, RayHit& firstHit, const Ray& second,
                          RayHit& secondHit) const {
  Walk<false> a(*this, first, firstHit), b(*this, second, secondHit);
  bool goingA = a.isInside(), goingB = b.isInside();
  while (goingA && goingB) {
    goingA = a.advance();
    goingB = b.advance();
  }
  while (goingA) goingA = a.advance();
  while (goingB) goingB = b.advance();
  a.finish();
  b.finish();
}

}  // namespace orris
