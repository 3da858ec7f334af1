// The stages of `orris validate` for one pack.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include "app/report/report.h"
#include "app/validate/matrix_budget.h"
#include "app/validate/validate_options.h"
#include "check/compile/program_check.h"
#include "check/compile/target_limits.h"
#include "pack/shader_pack.h"
#include "validate/driver_check.h"

namespace orris {

/// Programs by name, counted once whatever the number of profiles.
struct ProgramVerdicts {
  std::set<std::string> all, failed;
};

/// What was checked of one pack.
struct PackVerdict {
  std::string path;
  std::shared_ptr<const FileSource> files;  ///< nullptr: the pack could not be opened
  ProgramVerdicts programs;
  std::map<std::string, ProgramVerdicts> modPrograms;  ///< by name of the mod, "Distant Horizons"
  std::set<std::string> dimensions, profiles;
  std::vector<MatrixSummary> matrices;  ///< one for each profile, with --matrix
  std::set<std::size_t> ofMatrix;       ///< problems of the report that only other options have
  int status = kClean;
  bool cached = false;  ///< of an earlier run (result_cache.h)
};

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
  bool draw = true;  ///< a frame, with a driver
  std::chrono::seconds drawTime = kDrawTime;  ///< of the processor, for that frame

  MacroDefinitions environment(const HostVersions& versions) const;
  bool passed(std::uint64_t hash) const;
};

class ResultCache;

/// All of validatePack() for files that are open, as with edits that nobody has saved; `path` names them.
PackVerdict validateFiles(const std::string& path, std::shared_ptr<const FileSource> files,
                          const ValidateOptions& options, Checker& checker, Report& report);

/// Only what loading the programs of all folders and compiling them reports.
void compileFiles(std::shared_ptr<const FileSource> files, const ValidateOptions& options,
                  Checker& checker, Report& report);

/// Asks the driver that --draw needs; false: reported.
bool findDriver(const ValidateOptions& options, Checker& checker);

PackVerdict validatePack(const std::string& path, const ValidateOptions& options,
                         const ResultCache& cache, Checker& checker, Report& report);

}  // namespace orris
