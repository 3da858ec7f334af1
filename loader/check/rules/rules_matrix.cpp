// Option combinations and the run itself.
#include <vector>

#include <orris/check/rules/rule_tables.h>

namespace orris {

std::span<const Rule> matrixRules() {
  static const std::vector<Rule> kRules = {
      {"compiler-crash", Severity::Error, "a program kills the compiler or the GL driver"},
      {"compiler-timeout", Severity::Error,
       "the compiler or the GL driver does not finish with a program"},
      {"draw-timeout", Severity::Error, "the GL driver does not finish one frame in time"},
      {"driver-died", Severity::Error, "the process that draws died"},
      {"frame-timeout", Severity::Error, "drawing a frame or compiling a program takes too long", kHostFailed},
  };
  return kRules;
}

}  // namespace orris
