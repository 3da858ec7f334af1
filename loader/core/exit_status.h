// How a run ends, the worst last: what the exit status of every command means.
#pragma once

namespace orris {

enum ExitStatus {
  kClean = 0,
  kProblems = 1,    ///< the pack, world or comparison has problems
  kUsage = 2,       ///< wrong command line, or an input that cannot be read
  kHostFailed = 3,  ///< no GL context, disk full, a fault of ours
};

}  // namespace orris
