// What the frame reads and writes.
#include <vector>

#include "check/rule_tables.h"

namespace orris {

std::span<const Rule> frameRules() {
  static const std::vector<Rule> kRules = {};
  return kRules;
}

}  // namespace orris
