#include "check/target_limits.h"

#include <algorithm>
#include <array>

namespace orris {
namespace {

constexpr std::array<TargetLimits, 1> kTargets{{{.name = "mesa"}}};

}  // namespace

std::span<const TargetLimits> targetTable() { return kTargets; }

const TargetLimits* findTarget(std::string_view name) {
  const auto found = std::find_if(kTargets.begin(), kTargets.end(),
                                  [&](const TargetLimits& target) { return target.name == name; });
  return found == kTargets.end() ? nullptr : &*found;
}

}  // namespace orris
