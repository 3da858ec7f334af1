// Options, profiles and screens.
#include <vector>

#include <orris/check/rules/rule_tables.h>

namespace orris {

std::span<const Rule> optionRules() {
  static const std::vector<Rule> kRules = {
      {"language-file", Severity::Warning, "a language file is named after no language"},
      {"language-key", Severity::Warning,
       "a text in a language file is for something that does not exist, but nearly"},
      {"language-missing", Severity::Warning, "something on the screens has no English text"},
      {"language-stale", Severity::Warning,
       "a text in a language file is for something that does not exist"},
      {"language-twice", Severity::Warning, "a language file has two texts for one key"},
      {"option-ambiguous", Severity::Note, "an option has different defaults in two files"},
      {"option-default", Severity::Note, "the list of an option lacks its default"},
      {"option-hidden", Severity::Note, "no screen shows an option"},
      {"option-list-commas", Severity::Warning, "the values of an option are separated by commas"},
      {"option-list-differs", Severity::Warning,
       "an option has different lists of values in two lines"},
      {"option-unknown", Severity::Error, "a chosen option does not exist", kUsage},
      {"option-unused", Severity::Warning, "an option changes nothing"},
      {"option-value", Severity::Error, "a chosen value is not one of the option's values", kUsage},
      {"option-value-empty", Severity::Warning, "the list of an option has an empty value"},
      {"option-value-twice", Severity::Warning, "the list of an option has a value twice"},
      {"profile-hidden", Severity::Note, "no screen lets players choose a profile"},
      {"profile-option", Severity::Warning,
       "a profile sets an option that does not exist, or sets it without a value"},
      {"profile-program", Severity::Warning,
       "a profile disables a program that the pack does not have"},
      {"profile-recursion", Severity::Error, "profiles include each other in a circle"},
      {"profile-repeated", Severity::Warning, "a profile takes over the same profile twice"},
      {"profile-same", Severity::Note, "two profiles set the same"},
      {"profile-unknown", Severity::Error, "a profile that is asked for does not exist", kUsage},
      {"profile-value", Severity::Warning, "a profile sets a value that is not in the list"},
      {"screen-columns", Severity::Warning,
       "a number of columns is given for a screen that does not exist"},
      {"screen-option", Severity::Warning,
       "a screen shows an option or links a screen that does not exist"},
      {"screen-unlinked", Severity::Note, "no screen links to a screen"},
      {"slider-option", Severity::Warning,
       "the list of sliders names an option that does not exist"},
  };
  return kRules;
}

}  // namespace orris
