#include <orris/trace/grid/open_boxes.h>

#include <algorithm>
#include <thread>

namespace orris {
namespace {

// Beyond this many cells boxes would take longer to find than they save: cubes, then.
constexpr std::size_t kMostCellsForBoxes = std::size_t(1) << 23;

std::size_t offsetIn(glm::ivec3 size, glm::ivec3 p) {
  return std::size_t(p.x) +
         std::size_t(size.x) * (std::size_t(p.z) + std::size_t(size.z) * std::size_t(p.y));
}

/// Counts of occupied cells below each corner, so that any box is counted by eight look-ups.
class Counts {
 public:
  Counts(glm::ivec3 size, const std::vector<std::uint32_t>& cells)
      : size_(size),
        corners_(size + 1),
        sums_(std::size_t(corners_.x) * std::size_t(corners_.y) * std::size_t(corners_.z)) {
    for (int y = 0; y < size.y; ++y)
      for (int z = 0; z < size.z; ++z) {
        std::uint32_t row = 0;
        for (int x = 0; x < size.x; ++x) {
          row += cells[offsetIn(size, {x, y, z})] != 0;
          sums_[offsetIn(corners_, {x + 1, y + 1, z + 1})] =
              row + at({x + 1, y + 1, z}) + at({x + 1, y, z + 1}) - at({x + 1, y, z});
        }
      }
  }
  /// From `corner` on: `length` cells along each axis, toward `step`.
  bool isOpen(glm::ivec3 corner, glm::ivec3 length, glm::ivec3 step) const {
    const glm::ivec3 end = corner + step * (length - 1);
    const glm::ivec3 low = glm::min(corner, end), high = glm::max(corner, end) + 1;
    if (low.x < 0 || low.y < 0 || low.z < 0) return false;
    if (high.x > size_.x || high.y > size_.y || high.z > size_.z) return false;
    const auto slice = [&](int y) {
      return at({high.x, y, high.z}) - at({low.x, y, high.z}) - at({high.x, y, low.z}) +
             at({low.x, y, low.z});
    };
    return slice(high.y) == slice(low.y);
  }

 private:
  std::uint32_t at(glm::ivec3 p) const { return sums_[offsetIn(corners_, p)]; }
  glm::ivec3 size_, corners_;
  std::vector<std::uint32_t> sums_;
};

glm::ivec3 stepOf(int octant) {
  return {(octant & 1) != 0 ? 1 : -1, (octant & 2) != 0 ? 1 : -1, (octant & 4) != 0 ? 1 : -1};
}

// The largest empty cube with a corner in this cell is one larger than the smallest of those that
// begin in the seven cells next to it, as for the largest square in a bitmap.
void findCubes(glm::ivec3 size, const std::vector<std::uint32_t>& cells, glm::ivec3 step,
               std::vector<std::uint16_t>& boxes) {
  const auto ordered = [&](int i, int axis) { return step[axis] > 0 ? size[axis] - 1 - i : i; };
  for (int j = 0; j < size.y; ++j)
    for (int k = 0; k < size.z; ++k)
      for (int i = 0; i < size.x; ++i) {
        const glm::ivec3 p(ordered(i, 0), ordered(j, 1), ordered(k, 2));
        if (cells[offsetIn(size, p)] != 0) continue;
        int smallest = kLongestBox - 1;
        for (int n = 1; n < 8; ++n) {
          const glm::ivec3 q = p + step * glm::ivec3(n & 1, n >> 1 & 1, n >> 2);
          const bool inside =
              q.x >= 0 && q.y >= 0 && q.z >= 0 && q.x < size.x && q.y < size.y && q.z < size.z;
          smallest = std::min(smallest, inside ? boxX(boxes[offsetIn(size, q)]) : 0);
        }
        boxes[offsetIn(size, p)] = std::uint16_t(packBox(smallest + 1, smallest + 1, smallest + 1));
      }
}

/// The greatest length along an axis for which the box stays empty.
int stretch(const Counts& counts, glm::ivec3 corner, glm::ivec3 length, glm::ivec3 step, int axis) {
  int good = length[axis], bad = kLongestBox + 1;
  for (int grow = 1; good + 1 < bad; grow *= 2) {
    length[axis] = std::min(good + grow, bad - 1);
    const bool open = counts.isOpen(corner, length, step);
    (open ? good : bad) = length[axis];
    if (!open) grow = std::max(1, (bad - good) / 4);
  }
  return good;
}

/// Stretches a cube along each axis, farthest first.
glm::ivec3 stretchCube(const Counts& counts, glm::ivec3 corner, int cube, glm::ivec3 step) {
  glm::ivec3 length(cube);
  int order[3] = {0, 1, 2};
  glm::ivec3 reach;
  for (int axis = 0; axis < 3; ++axis) reach[axis] = stretch(counts, corner, length, step, axis);
  std::sort(order, order + 3, [&](int a, int b) { return reach[a] > reach[b]; });
  for (const int axis : order) length[axis] = stretch(counts, corner, length, step, axis);
  return length;
}

void stretchCubes(glm::ivec3 size, const Counts& counts, glm::ivec3 step,
                  std::vector<std::uint16_t>& boxes) {
  for (int y = 0; y < size.y; ++y)
    for (int z = 0; z < size.z; ++z)
      for (int x = 0; x < size.x; ++x) {
        std::uint16_t& box = boxes[offsetIn(size, {x, y, z})];
        if (box == 0 || boxX(box) == kLongestBox) continue;
        const glm::ivec3 length = stretchCube(counts, {x, y, z}, boxX(box), step);
        box = std::uint16_t(packBox(length.x, length.y, length.z));
      }
}

}  // namespace

OpenBoxes measureOpenBoxes(glm::ivec3 size, const std::vector<std::uint32_t>& cells) {
  OpenBoxes boxes;
  const bool stretched = cells.size() <= kMostCellsForBoxes;
  const Counts counts = stretched ? Counts(size, cells) : Counts(glm::ivec3(0), {});
  const auto measure = [&](int first) {
    for (int octant = first; octant < 8; octant += 2) {
      auto& own = boxes[std::size_t(octant)];
      own.assign(cells.size(), 0);
      findCubes(size, cells, stepOf(octant), own);
      if (stretched) stretchCubes(size, counts, stepOf(octant), own);
    }
  };
  std::thread helper(measure, 1);
  measure(0);
  helper.join();
  return boxes;
}

}  // namespace orris
