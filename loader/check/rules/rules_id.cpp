// Id maps.
#include <vector>

#include <orris/check/rules/rule_tables.h>

namespace orris {

std::span<const Rule> idRules() {
  static const std::vector<Rule> kRules = {
      {"id-block", Severity::Warning, "an id map names a block that the game does not have"},
      {"id-key-twice", Severity::Warning, "a key of an id map is given twice"},
      {"id-layer", Severity::Warning, "an id map names a render layer that does not exist"},
      {"id-letter-lost", Severity::Warning, "Iris loses the last letter of a name"},
      {"id-number", Severity::Warning, "a line of an id map has no number"},
      {"id-property", Severity::Warning,
       "a block state names a property or a value that no block has"},
      {"id-repeated", Severity::Note, "a name stands in an id map twice"},
      {"id-state", Severity::Warning, "a block state in an id map is no property=value"},
      {"id-stray-line", Severity::Warning, "a line of an id map belongs to no key"},
      {"id-swallowed", Severity::Warning,
       "a key belongs to the list of the line before, which ends in a backslash"},
      {"id-twice", Severity::Warning, "a block has an id already"},
  };
  return kRules;
}

}  // namespace orris
