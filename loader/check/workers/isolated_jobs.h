// Work that may kill or stall its process: done in forked workers, so that one bad job costs one
// worker and the rest goes on.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>

namespace orris {

/// What became of one job.
struct JobOutcome {
  enum class Kind { Done, Crashed, TimedOut };
  Kind kind = Kind::Done;
  std::string result;  ///< what the work returned, if Done
  std::string cause;   ///< of a crash, for people: "signal 11 (Segmentation fault)"
};

struct IsolatedJobs {
  std::size_t count = 0;
  int workers = 1;  ///< 0: all in this process, without any of what follows but `work` and `until`: debuggers, fuzzing
  std::function<std::string(std::size_t)> work;    ///< runs in a worker, with what the caller had
  std::chrono::seconds time{30};                   ///< processor time that one job may take
  std::size_t memoryBytes = std::size_t{4} << 30;  ///< addresses that a worker may use, 0: any
  std::size_t resultBytes = std::size_t{1} << 30;  ///< of one job; a longer result is a crash
  bool confined = true;  ///< in a sandbox (check/workers/sandbox.h); drivers of graphics cards need more
  bool driver = false;   ///< with the folder in which software rasterisers keep compiled programs
  /// When all ends: jobs in progress are given up and not handed over.
  std::optional<std::chrono::steady_clock::time_point> until{};
};

/// Runs all jobs and hands over each outcome as it comes, in no fixed order; when `take` returns
/// false no further job starts. The caller must have no second thread and hold no GL context, for
/// neither lives on in a fork. A job that neither ends nor computes is given up after ten times its
/// processor time. What a worker sends is taken as a stranger's: nothing in it makes the caller wait or
/// take more memory than `resultBytes`. Standard output of a worker goes nowhere.
void runIsolated(const IsolatedJobs& jobs,
                 const std::function<bool(std::size_t index, JobOutcome outcome)>& take);

}  // namespace orris
