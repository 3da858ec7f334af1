// Options, profiles and screens.
#include <vector>

#include "check/rule_tables.h"

namespace orris {

std::span<const Rule> optionRules() {
  static const std::vector<Rule> kRules = {
      {"option-ambiguous", Severity::Note, "an option has different defaults in two files"},
      {"option-unknown", Severity::Error, "a chosen option does not exist"},
      {"option-value", Severity::Error, "a chosen value is not one of the option's values"},
      {"profile-option", Severity::Warning,
       "a profile sets an option that does not exist, or sets it without a value"},
      {"profile-recursion", Severity::Error, "profiles include each other in a circle"},
      {"profile-unknown", Severity::Error, "a profile that is asked for does not exist"},
      {"screen-option", Severity::Warning,
       "a screen shows an option or links a screen that does not exist"},
  };
  return kRules;
}

}  // namespace orris
