// The same rays through Embree.
#pragma once

#include <ctime>
#include <vector>

#include <orris/trace/grid/voxel_grid.h>

namespace orris {

/// Processor time of this thread: others may use the machine too.
inline double threadSeconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

struct EmbreeTimes {
  bool present = false;  ///< the build found Embree
  double seconds = 0;    ///< best round
  std::uint64_t hits = 0;
};

/// All opaque quads as Embree quads; alpha tests by a filter function, as Embree does them.
EmbreeTimes measureEmbree(const VoxelGrid& grid, const std::vector<Ray>& rays, int rounds);

}  // namespace orris
