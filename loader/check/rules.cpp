#include "check/rules.h"

#include <algorithm>
#include <array>

namespace orris {
namespace {

constexpr std::array<Rule, 1> kRules{{
    {"glsl-compile", Severity::Error, "a stage does not compile"},
}};

}  // namespace

std::span<const Rule> ruleTable() { return kRules; }

const Rule* findRule(std::string_view id) {
  const auto found =
      std::find_if(kRules.begin(), kRules.end(), [&](const Rule& rule) { return rule.id == id; });
  return found == kRules.end() ? nullptr : &*found;
}

}  // namespace orris
