// Every id that a diagnostic can carry, with what it means: for reports, for silencing, and for the
// docs page of each (docs/checks.md).
#pragma once

#include <span>
#include <string_view>

#include "core/diagnostic.h"

namespace orris {

struct Rule {
  std::string_view id;       ///< "uniform-unknown"
  Severity severity;         ///< as reported unless the user says otherwise
  std::string_view summary;  ///< one sentence, what is wrong
};

/// Sorted by id.
std::span<const Rule> ruleTable();
const Rule* findRule(std::string_view id);

}  // namespace orris
