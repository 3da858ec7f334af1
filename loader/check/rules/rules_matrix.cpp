// Option combinations and the run itself.
#include <vector>

#include "check/rules/rule_tables.h"

namespace orris {

std::span<const Rule> matrixRules() {
  static const std::vector<Rule> kRules = {
      {"compiler-crash", Severity::Error, "a program kills the compiler or the GL driver"},
      {"compiler-timeout", Severity::Error,
       "the compiler or the GL driver does not finish with a program"},
      {"draw-timeout", Severity::Warning, "the GL driver does not finish one frame in time"},
  };
  return kRules;
}

}  // namespace orris
