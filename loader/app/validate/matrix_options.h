// The flags of `orris validate` that ask for an option matrix, and what of it is reported at the end.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "check/matrix/matrix_run.h"

namespace CLI {
class App;
}

namespace orris {

/// As the command line gives them.
struct MatrixOptions {
  std::string kind = "none";
  std::vector<std::string> options;
  std::string shard;   ///< "2/5"; "": as the environment of a CI job says, else all
  std::string budget;  ///< "90s", "5m"; "": no end
};

void addMatrixFlags(CLI::App& command, MatrixOptions& options);

/// A bad shard or budget was refused by the flags' own checks.
MatrixRequest matrixRequest(const MatrixOptions& options, int jobs);
std::optional<std::chrono::seconds> matrixTime(const MatrixOptions& options);

/// What ran, for one profile ("" for the values as they are).
struct MatrixSummary {
  std::string kind, profile;
  int shard = 1, shards = 1;
  std::size_t configurations = 0, tried = 0, variants = 0, compiled = 0;
  bool all = true;  ///< false: of the configurations not all were counted
  double seconds = 0;
};

}  // namespace orris
