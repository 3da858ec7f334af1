// What the workers of a matrix do: build one program under one set of values and compile what is
// new of it.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "check/matrix_plan.h"
#include "check/shared_hashes.h"

namespace orris {

/// What one program of one configuration gave.
struct MatrixFinding {
  std::vector<std::uint64_t> units;    ///< hashes of its units
  std::vector<std::uint64_t> failing;  ///< those compiled here that have errors
  int compiled = 0;                    ///< units that nobody had compiled before
  Diagnostics errors;                  ///< of building it, not of compiling it
};

std::string encode(const MatrixFinding& finding);
MatrixFinding decodeFinding(const std::string& bytes);

class MatrixWorker {
 public:
  MatrixWorker(const MatrixPlan& plan, const MacroDefinitions& environment)
      : plan_(plan), variants_(plan, environment) {}

  /// Compiles units that `seen` lacks.
  MatrixFinding run(const MatrixJob& job, SharedHashes& seen);
  /// Errors of the program of `job` (or of the properties) under `values`, compiler's included.
  Diagnostics errorsWith(const MatrixJob& job, const OptionValues& values);
  /// Options that decide about the program under `values`: conditions in its text and properties.
  std::vector<std::string> deciding(const MatrixJob& job, const OptionValues& values);

 private:
  const MatrixPlan& plan_;
  MatrixVariants variants_;
};

}  // namespace orris
