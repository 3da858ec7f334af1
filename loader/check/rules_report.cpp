// Silencing, baselines and logs.
#include <vector>

#include "check/rule_tables.h"

namespace orris {

std::span<const Rule> reportRules() {
  static const std::vector<Rule> kRules = {};
  return kRules;
}

}  // namespace orris
