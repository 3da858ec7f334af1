// From the failures of a matrix to one report for each mistake, with the values that it needs.
#pragma once

#include <chrono>
#include <optional>
#include <vector>

#include <orris/check/matrix/matrix_worker.h>

namespace orris {

/// One problem wherever it occurs.
struct MatrixFailure {
  Diagnostic diagnostic;          ///< as in the first job
  std::vector<std::size_t> jobs;  ///< those that have it, in order
  bool lost = false;              ///< the job killed or stalled the compiler
};

struct CauseSearch {
  const MatrixPlan& plan;
  MatrixWorker& worker;
  int jobs = 1;                                                  ///< processes
  std::optional<std::chrono::steady_clock::time_point> until{};  ///< then it says what it knows
};

/// Adds to each failure a note with its cause and where it occurs.
void explainFailures(const CauseSearch& search, std::vector<MatrixFailure>& failures);

}  // namespace orris
