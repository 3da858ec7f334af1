// Compiling and linking.
#include <vector>

#include <orris/check/rules/rule_tables.h>

namespace orris {

std::span<const Rule> glslRules() {
  static const std::vector<Rule> kRules = {
      {"brace-unbalanced", Severity::Error, "a brace is missing, or one is too many"},
      {"driver-compile", Severity::Error, "the GL driver refuses a stage that glslang accepts"},
      {"driver-log", Severity::Warning, "the GL driver says something that has no line"},
      {"glsl-compile", Severity::Error, "a stage does not compile"},
      {"glsl-link", Severity::Error, "the stages of a program do not fit together"},
      {"rule-applied", Severity::Note, "the host changed the source so that modern GLSL takes it"},
      {"unused-function-broken", Severity::Warning,
       "a function that nothing calls would not compile"},
  };
  return kRules;
}

}  // namespace orris
