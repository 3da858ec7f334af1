// What the command line asks of `orris validate`.
#pragma once

#include <string>
#include <vector>

#include "app/input/common.h"
#include "app/output/report_options.h"
#include "app/validate/matrix_options.h"
#include <orris/validate/validate_options.h>

namespace orris {

struct ValidateFlags {
  std::vector<std::string> paths;
  ValidateOptions validate;
  std::string target = "iris";
  bool noCache = false;            ///< leave the cache alone
  std::string frameTime = "300s";  ///< of processor time, for --draw
  bool recursive = false;          ///< the packs below each path
  std::string explainLog;          ///< file, or "-"
  std::string patchedShaders;      ///< folder that Iris wrote
  std::string stage;               ///< "composite.fsh": what a bare driver log is about
  OutputOptions output;
  ReportOptions report;
  MatrixOptions matrix;
};

}  // namespace orris
