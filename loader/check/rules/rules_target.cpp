// Render targets and directives in sources.
#include <vector>

#include <orris/check/rules/rule_tables.h>

namespace orris {

std::span<const Rule> targetRules() {
  static const std::vector<Rule> kRules = {
      {"directive-misspelt", Severity::Warning,
       "a constant or comment has nearly the name of a directive"},
      {"directive-slip", Severity::Warning, "a const directive means something else in Iris"},
      {"directive-value", Severity::Warning, "a const directive has a value that cannot be used"},
      {"format-unknown", Severity::Error, "a texture format does not exist"},
      {"render-target-limit", Severity::Error,
       "a buffer of RENDERTARGETS or DRAWBUFFERS does not exist"},
      {"render-target-syntax", Severity::Error,
       "a RENDERTARGETS or DRAWBUFFERS comment cannot be read"},
      {"target-format", Severity::Error, "a render target has a format that cannot be drawn to"},
      {"target-size-mismatch", Severity::Error, "one program draws to targets of different sizes"},
  };
  return kRules;
}

}  // namespace orris
