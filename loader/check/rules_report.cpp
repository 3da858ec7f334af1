// Silencing, baselines and logs.
#include <vector>

#include "check/rule_tables.h"

namespace orris {

std::span<const Rule> reportRules() {
  static const std::vector<Rule> kRules = {
      {"baseline-syntax", Severity::Error, "a baseline file cannot be read"},
      {"ignore-unknown", Severity::Warning, "an ignore comment names an id that does not exist"},
      {"ignore-unused", Severity::Note, "an ignore comment silences nothing"},
  };
  return kRules;
}

}  // namespace orris
