// Option combinations and the run itself.
#include <vector>

#include "check/rule_tables.h"

namespace orris {

std::span<const Rule> matrixRules() {
  static const std::vector<Rule> kRules = {};
  return kRules;
}

}  // namespace orris
