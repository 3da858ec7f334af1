// Results of `orris validate` that outlive a run: what is known of a pack of which every byte, and every
// flag that counts, is as it was.
#pragma once

#include <optional>
#include <string>

#include <orris/report/problem_list.h>
#include <orris/validate/validate_options.h>
#include <orris/validate/validate_pack.h>

namespace orris {

/// A folder of files, each named by the hash of what its result depends on: the pack's files, the flags and
/// this program. An entry that is not whole counts as none; entries are put in place at once, so that
/// several runs may share the folder. Who may write to the folder decides what a run reports.
class ResultCache {
 public:
  /// "" for a cache that keeps nothing.
  explicit ResultCache(std::string folder) : folder_(std::move(folder)) {}

  /// The name of the entry for `files`; nullopt where a run has more than a report to give, or depends on more
  /// than what is hashed: on the driver, or on files beside `shaders/`.
  std::optional<std::string> keyOf(const FileSource& files, const ValidateOptions& options) const;
  /// Fills `verdict` and the empty `problems` from the entry; false: there is none.
  bool restore(const std::string& key, PackVerdict& verdict, ProblemList& problems) const;
  /// Leaves out what ran out of time. Failures to write are no problem of the pack, and are not reported. The oldest entries go where
  /// there are too many.
  void keep(const std::string& key, const PackVerdict& verdict, const ProblemList& problems) const;

 private:
  std::string folder_;
};

}  // namespace orris
