// Silencing, baselines and logs.
#include <vector>

#include <orris/check/rules/rule_tables.h>

namespace orris {

std::span<const Rule> reportRules() {
  static const std::vector<Rule> kRules = {
      {"baseline-syntax", Severity::Error, "a baseline file cannot be read", kUsage},
      {"ignore-unknown", Severity::Warning, "an ignore comment names an id that does not exist"},
      {"ignore-unused", Severity::Note, "an ignore comment silences nothing"},
      {"log-empty", Severity::Note, "a game log holds no message of a shader compiler"},
      {"log-message", Severity::Error, "a game log holds a compiler message about this place"},
      {"log-program", Severity::Warning, "a game log names a shader that the pack does not have"},
  };
  return kRules;
}

}  // namespace orris
