// Id maps.
#include <vector>

#include "check/rule_tables.h"

namespace orris {

std::span<const Rule> idRules() {
  static const std::vector<Rule> kRules = {
      {"id-layer", Severity::Warning, "an id map names a render layer that does not exist"},
      {"id-number", Severity::Warning, "a line of an id map has no number"},
      {"id-state", Severity::Warning, "a block state in an id map is no property=value"},
      {"id-stray-line", Severity::Warning, "a line of an id map belongs to no key"},
  };
  return kRules;
}

}  // namespace orris
