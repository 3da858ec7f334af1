// The stages of `orris validate` for one pack.
#pragma once

#include <memory>
#include <set>
#include <string>

#include "app/report.h"
#include "app/validate_options.h"
#include "check/program_check.h"
#include "check/target_limits.h"
#include "pack/shader_pack.h"

namespace orris {

/// What was checked of one pack. Programs are counted once, whatever the number of profiles.
struct PackVerdict {
  std::string path;
  std::set<std::string> programs, failed, dimensions, profiles;
  int status = kClean;
};

/// Checks shared by all packs of a run: the driver's context (with --draw), and what was checked.
struct Checker {
  int jobs = 1;
  const TargetLimits& target;
  std::unique_ptr<gl::Context> context;
  Verdicts glslang, driver;

  MacroDefinitions environment() const;
  bool passed(std::uint64_t hash) const;
};

/// Makes the context that --draw needs; false: reported.
bool openContext(const ValidateOptions& options, Checker& checker);

PackVerdict validatePack(const std::string& path, const ValidateOptions& options, Checker& checker,
                         Report& report);

}  // namespace orris
