// The flags of `orris validate` that ask for an option matrix.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include <orris/check/matrix/matrix_run.h>

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
MatrixRequest matrixRequest(const MatrixOptions& options);
std::optional<std::chrono::seconds> matrixTime(const MatrixOptions& options);

}  // namespace orris
