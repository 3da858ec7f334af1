// From diagnostics to findings: what the user's severities, comments and baseline make of them.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <orris/report/baseline.h>
#include <orris/report/pack_verdict.h>
#include <orris/report/problem_list.h>

namespace orris {

/// What a user makes of problems.
struct JudgeOptions {
  std::map<std::string, std::optional<Severity>> severities;  ///< by id; nullopt: off
  bool strict = false;                                        ///< warnings make the exit status 1
  std::optional<std::string> sourceRoot;  ///< where the pack's files are, seen from the repository
};

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
  bool verbose = false;  ///< notes are written, too
  int status = kClean;
};

/// Judges the problems of one pack; `baseline` may be null.
PackResult judgePack(PackVerdict verdict, const ProblemList& problems, const JudgeOptions& options,
                     Baseline* baseline);
/// Adds one judged pack, to whose findings the baseline of `result` applies.
void addPack(ValidateResult& result, PackVerdict verdict, const ProblemList& problems,
             const JudgeOptions& options);

/// Whether a finding makes the exit status 1.
bool countsAsFailure(const Finding& finding, bool strict);

/// The text of a baseline (Baseline::parse) of all that was found, known problems among it.
std::string baselineOf(const ValidateResult& result);

}  // namespace orris
