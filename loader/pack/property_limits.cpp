#include "pack/property_limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/limits.h"

namespace orris {
namespace {

struct Kind {
  std::string_view prefix;
  std::size_t most;
};

constexpr std::array<Kind, 6> kKinds{{{"profile.", limits::kProfiles},
                                      {"screen.", limits::kScreenKeys},
                                      {"uniform.", limits::kCustomUniforms},
                                      {"variable.", limits::kCustomUniforms},
                                      {"texture.", limits::kTextureKeys},
                                      {"customTexture.", limits::kTextureKeys}}};

}  // namespace

void limitProperties(std::vector<PropertyEntry>& entries, Diagnostics& diagnostics) {
  std::array<std::size_t, kKinds.size()> counts{};
  std::erase_if(entries, [&](const PropertyEntry& entry) {
    const auto kind = std::find_if(kKinds.begin(), kKinds.end(),
                                   [&](const Kind& k) { return entry.key.starts_with(k.prefix); });
    if (kind == kKinds.end()) return false;
    const std::size_t count = ++counts[static_cast<std::size_t>(kind - kKinds.begin())];
    if (count == kind->most + 1) {
      diagnostics.push_back(
          propertyDiagnostic(Severity::Error, "property-limit", entry,
                             fmt::format("more than {} keys {}*; those from here on are left out",
                                         kind->most, kind->prefix)));
    }
    return count > kind->most;
  });
}

}  // namespace orris
