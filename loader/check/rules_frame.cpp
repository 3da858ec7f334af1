// What the frame reads and writes.
#include <vector>

#include "check/rule_tables.h"

namespace orris {

std::span<const Rule> frameRules() {
  static const std::vector<Rule> kRules = {
      {"target-unread", Severity::Warning, "a render target is drawn to, but nothing reads it"},
      {"target-unwritten", Severity::Warning,
       "a render target is read while nothing can be in it but its clear colour"},
  };
  return kRules;
}

}  // namespace orris
