// Names and interfaces of programs.
#include <vector>

#include "check/rule_tables.h"

namespace orris {

std::span<const Rule> interfaceRules() {
  static const std::vector<Rule> kRules = {};
  return kRules;
}

}  // namespace orris
