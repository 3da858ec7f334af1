// Names and interfaces of programs.
#include <vector>

#include <orris/check/rules/rule_tables.h>

namespace orris {

std::span<const Rule> interfaceRules() {
  static const std::vector<Rule> kRules = {
      {"attribute-type", Severity::Error, "a vertex attribute has a type that Iris does not make"},
      {"attribute-unknown", Severity::Warning, "no host sets a vertex attribute of this name"},
      {"include-probably-missing", Severity::Error,
       "a name is unknown, and a file that defines it is not included"},
      {"name-misspelt", Severity::Error,
       "a declaration that nothing uses is a slip away from a name that nothing declares"},
      {"name-reserved", Severity::Error, "a name begins as those of Iris's own code do"},
      {"output-none", Severity::Warning, "a program writes nothing"},
      {"output-overlap", Severity::Error, "two outputs have the same location"},
      {"output-unlisted", Severity::Warning, "an output goes to no buffer"},
      {"output-unwritten", Severity::Warning, "a listed buffer gets no output"},
      {"program-file-alone", Severity::Warning, "a vertex stage has no fragment stage"},
      {"program-file-unknown", Severity::Warning, "a program file has a name that no host reads"},
      {"program-folder-unknown", Severity::Warning,
       "a folder of programs is nearly called like one that a dimension uses"},
      {"sampler-format", Severity::Warning,
       "a sampler or image cannot read numbers of this format"},
      {"sampler-type", Severity::Warning, "a sampler or image does not fit what is bound to it"},
      {"target-limit", Severity::Warning,
       "a program needs more than the target of --target offers"},
      {"uniform-conflict", Severity::Error,
       "a uniform has different types in two stages of a program"},
      {"uniform-type", Severity::Error, "a uniform has another type than the host gives"},
      {"uniform-unknown", Severity::Warning,
       "no host sets a uniform, sampler or image of this name"},
      {"varying-interpolation", Severity::Warning, "two stages interpolate a varying differently"},
      {"varying-missing", Severity::Warning,
       "a stage reads what the one before it does not declare"},
      {"varying-type", Severity::Error, "a varying has different types in two stages"},
      {"varying-unread", Severity::Note, "a stage writes what the next one does not read"},
      {"varying-unwritten", Severity::Warning, "a stage reads what the one before it never writes"},
      {"version-newer", Severity::Warning,
       "a name is newer than the Iris or the game that the pack is checked for"},
  };
  return kRules;
}

}  // namespace orris
