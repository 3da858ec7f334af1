#include <orris/check/rules/rules.h>

#include <algorithm>
#include <vector>

#include <orris/check/rules/rule_tables.h>

namespace orris {
namespace {

std::vector<Rule> sortedRules() {
  std::vector<Rule> rules;
  for (const std::span<const Rule> table :
       {chartRules(), frameRules(), glslRules(), hostRules(), idRules(), interfaceRules(),
        matrixRules(), optionRules(), propertyRules(), reportRules(), targetRules(), textRules()}) {
    rules.insert(rules.end(), table.begin(), table.end());
  }
  std::ranges::sort(rules, {}, &Rule::id);
  return rules;
}

ExitStatus causedBy(const Diagnostic& diagnostic) {
  const Rule* rule = findRule(diagnostic.id);
  // A profile that a line of the pack asks for is the pack's mistake.
  const bool ofPack = diagnostic.id == "profile-unknown" && diagnostic.at.line > 0;
  return rule == nullptr || ofPack ? kProblems : rule->status;
}

}  // namespace

std::span<const Rule> ruleTable() {
  static const std::vector<Rule> kRules = sortedRules();
  return kRules;
}

const Rule* findRule(std::string_view id) {
  const auto rules = ruleTable();
  const auto found = std::ranges::lower_bound(rules, id, {}, &Rule::id);
  return found == rules.end() || found->id != id ? nullptr : &*found;
}

ExitStatus statusOf(const Diagnostics& diagnostics) {
  ExitStatus status = kClean;
  for (const Diagnostic& diagnostic : diagnostics) {
    if (diagnostic.severity != Severity::Error) continue;
    status = std::max(status, causedBy(diagnostic));
  }
  return status;
}

}  // namespace orris
