// What the command line asks of `orris validate`.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "app/input/common.h"
#include "app/report/report_options.h"
#include "app/validate/matrix_options.h"

namespace orris {

struct ValidateOptions {
  std::vector<std::string> paths;
  PackOptions pack;
  std::vector<std::string> profiles;  ///< {"all"}, names, or none: the values as they are
  std::vector<std::string> dimensions{"all"};
  int jobs = std::max(1, int(std::thread::hardware_concurrency()));
  std::string target = "iris";           ///< row of targetTable()
  std::optional<VersionRange> versions;  ///< nullopt: from what the pack states to the newest
  std::string patched;                   ///< folder
  std::string cache;                     ///< folder of earlier results; "": none
  bool noCache = false;                  ///< leave `cache` alone
  bool draw = false;
  std::string frameTime = "300s";  ///< of processor time, for --draw
  bool recursive = false;  ///< the packs below each path
  gl::Backend backend = gl::Backend::Auto;
  std::string explainLog;      ///< file, or "-"
  std::string patchedShaders;  ///< folder that Iris wrote
  std::string stage;           ///< "composite.fsh": what a bare driver log is about
  OutputOptions output;
  ReportOptions report;
  MatrixOptions matrix;
};

}  // namespace orris
