// Which programs a matrix has to look at: of each configuration those that it can change.
#pragma once

#include <deque>
#include <memory>
#include <string>
#include <vector>

#include <orris/check/matrix/matrix_run.h>
#include <orris/pack/programs/folder_build.h>

namespace orris {

/// One program of one configuration; without an entry, the properties.
struct MatrixJob {
  std::size_t configuration = 0;
  std::size_t build = 0;  ///< index into MatrixPlan::builds
  const ProgramEntry* entry = nullptr;
};

struct MatrixPlan {
  std::vector<OptionValues> configurations;
  std::size_t left = 0;  ///< configurations that there was no time to plan for
  bool all = true;       ///< false: nor to count them to the end
  /// Of the values in force, one for each folder. Programs of other mods are left out: what fails in
  /// them is no error of the pack.
  std::vector<std::shared_ptr<const FolderBuild>> builds;
  std::vector<MatrixJob> jobs;                    ///< in the order of configurations
  std::deque<std::vector<ProgramEntry>> entries;  ///< own those of the jobs
};

/// Configurations for which there is no job by `until` are left.
MatrixPlan planMatrix(const MatrixBase& base, const MatrixRequest& request,
                      std::optional<std::chrono::steady_clock::time_point> until = {});

/// Builds of the plan under other values, one after the other; those of one configuration share what
/// they can.
class MatrixVariants {
 public:
  MatrixVariants(const MatrixPlan& plan, const MacroDefinitions& environment)
      : plan_(plan), environment_(environment) {}
  /// Valid until the next call.
  const FolderBuild& get(std::size_t build, const OptionValues& values);

 private:
  const MatrixPlan& plan_;
  const MacroDefinitions& environment_;
  std::shared_ptr<const FolderBuild> last_;
};

}  // namespace orris
