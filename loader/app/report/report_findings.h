// From diagnostics to findings: what the user's severities, comments and baseline make of them.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "app/report/report.h"
#include "app/report/report_options.h"
#include "app/validate/validate_run.h"
#include "check/report/baseline.h"

namespace orris {

/// Why a problem is not reported.
enum class Silence { None, Comment, Flag, Baseline };

struct Finding {
  Diagnostic diagnostic;
  std::string fingerprint;         ///< stable when lines move
  std::string uri;                 ///< the file as the repository names it
  std::set<std::string> programs;  ///< "/world0/composite": those that it was met in
  Silence silence = Silence::None;
  bool milder = false;  ///< turned off or lowered by --ignore or --severity
  std::vector<Finding> follows{};  ///< what is gone once this one is mended; these follow from none
};

/// One pack, judged.
struct PackResult {
  PackVerdict verdict;
  std::string root;               ///< uri of the shaders folder, "" when the pack was not opened
  /// Those that others follow from, or may, then by severity, the worst first; then by file, line and column.
  std::vector<Finding> findings;
};

/// All packs of a run.
struct ValidateResult {
  std::vector<PackResult> packs;
  std::optional<Baseline> baseline;
  bool strict = false;
  bool verbose = false;
  int status = kClean;
};

/// Judges what was reported of one pack; `baseline` may be null.
PackResult judgePack(PackVerdict verdict, const Report& report, const ReportOptions& options,
                     Baseline* baseline);

/// Whether a finding makes the exit status 1.
bool countsAsFailure(const Finding& finding, bool strict);

}  // namespace orris
