// Checking packs without a world: what `orris validate` finds.
//   ValidateOptions options;
//   options.pack.path = "MyPack.zip";
//   const ValidateResult result = validatePack(options);
//   std::cout << writeSarif(result);  // report_format.h
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <orris/check/compile/program_check.h>
#include <orris/check/compile/target_limits.h>
#include <orris/check/hints/trial_memo.h>
#include <orris/pack/shader_pack.h>
#include <orris/report/findings.h>
#include <orris/report/problem_list.h>
#include <orris/validate/driver_check.h>
#include <orris/validate/matrix_budget.h>
#include <orris/validate/validate_options.h>

namespace orris {

struct PackOutline;

/// Checks shared by all packs of a run: the driver (with --draw), and what was checked. This process
/// never holds a context: work with the driver is done in others.
struct Checker {
  int jobs = 1;
  const TargetLimits& target;
  gl::Backend backend = gl::Backend::Auto;
  MatrixBudget budget;
  std::optional<gl::DriverInfo> gpu;
  Verdicts glslang, driver;
  std::set<std::uint64_t>* quiet = nullptr;  ///< learns of checkWithGlslang(); may be null
  /// Of the pack in hand: its copies, which check it with repairs, learn from one another.
  std::shared_ptr<TrialMemo> trials = std::make_shared<TrialMemo>();
  bool draw = true;  ///< a frame, with a driver
  std::chrono::seconds drawTime = kDrawTime;  ///< of the processor, for that frame
  /// Of the check before, by versions ("": the newest); it may be of the same pack before an edit:
  /// programs that nothing reaches that changed are taken over.
  std::map<std::string, std::shared_ptr<const std::vector<ShaderPack>>> folders;
  std::shared_ptr<const PackOutline> outline;  ///< of compileEdited(), for the same files

  MacroDefinitions environment(const HostVersions& versions) const;
  bool passed(std::uint64_t hash) const;
};

/// Checks the pack that `options` name, and opens no context in this process. A driver that
/// `options.draw` asks for and that is not there is a problem, too.
ValidateResult validatePack(const ValidateOptions& options);

/// The checks of `options` for a run of so many packs. nullopt: the driver that they ask for is missing.
std::optional<Checker> makeChecker(const ValidateOptions& options, std::size_t packs,
                                   Diagnostics& diagnostics);

class ResultCache;

/// Checks one of several packs: what is known of a text needs no second check.
PackVerdict validatePath(const std::string& path, const ValidateOptions& options,
                         const ResultCache& cache, Checker& checker, ProblemList& problems);

/// All of it for files that are open, as with edits that nobody has saved; `path` names them.
PackVerdict validateFiles(const std::string& path, std::shared_ptr<const FileSource> files,
                          const ValidateOptions& options, Checker& checker, ProblemList& problems);

}  // namespace orris
