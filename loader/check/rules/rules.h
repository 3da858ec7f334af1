// Every id that a diagnostic can carry, with what it means: for reports, for silencing, and for the
// docs page of each (docs/checks.md).
#pragma once

#include <span>
#include <string_view>

#include <orris/core/diagnostic.h>
#include <orris/core/exit_status.h>

namespace orris {

struct Rule {
  std::string_view id;       ///< "uniform-unknown"
  Severity severity;         ///< as reported unless the user says otherwise
  std::string_view summary;  ///< one sentence, what is wrong
  ExitStatus status = kProblems;  ///< of a run that ends by it
};

/// Sorted by id.
std::span<const Rule> ruleTable();
const Rule* findRule(std::string_view id);

/// The exit status of a run that ends by the errors of `diagnostics`; kClean when there are none.
ExitStatus statusOf(const Diagnostics& diagnostics);

}  // namespace orris
