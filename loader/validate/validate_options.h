// What of a pack is checked, and how.
#pragma once

#include <algorithm>
#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <orris/check/compile/target_limits.h>
#include <orris/check/matrix/matrix_run.h>
#include <orris/gl/context.h>
#include <orris/pack/options/pack_options.h>
#include <orris/report/findings.h>
#include <orris/validate/driver_check.h>

namespace orris {

struct ValidateOptions {
  PackOptions pack;                   ///< its versions are not used
  std::vector<std::string> profiles;  ///< {"all"}, names, or none: the values as they are
  std::vector<std::string> dimensions{"all"};
  int jobs = std::max(1, int(std::thread::hardware_concurrency()));  ///< processes; 0: none but this (isolated_jobs.h)
  const TargetLimits* target = findTarget("iris");
  std::optional<VersionRange> versions;  ///< nullopt: from what the pack states to the newest
  std::string patched;  ///< folder for the sources as the driver gets them; "": they are not written
  std::string cache;    ///< folder of earlier results; "": none
  bool draw = false;    ///< compile and link with the GL driver, too, and draw one frame
  gl::Backend backend = gl::Backend::Auto;
  std::chrono::seconds drawTime = kDrawTime;  ///< of the processor, for that frame
  MatrixRequest matrix;                       ///< its end and its jobs are set by the run
  std::optional<std::chrono::seconds> matrixTime;  ///< for the matrices of a run; nullopt: no end
  /// Of a matrix; may be empty.
  std::function<void(std::size_t done, std::size_t total)> progress;
  JudgeOptions judge;
  std::optional<Baseline> baseline;  ///< known problems
};

}  // namespace orris
