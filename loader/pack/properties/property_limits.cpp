#include <orris/pack/properties/property_limits.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include <orris/core/limits.h>

namespace orris {
namespace {

struct KeyLimit {
  std::string_view prefix;
  std::size_t most;
};

constexpr std::array<KeyLimit, 6> kKeyLimits{{{"profile.", limits::kProfiles},
                                              {"screen.", limits::kScreenKeys},
                                              {"uniform.", limits::kCustomUniforms},
                                              {"variable.", limits::kCustomUniforms},
                                              {"texture.", limits::kTextureKeys},
                                              {"customTexture.", limits::kTextureKeys}}};

}  // namespace

void limitProperties(std::vector<PropertyEntry>& entries, Diagnostics& diagnostics) {
  std::array<std::size_t, kKeyLimits.size()> counts{};
  std::erase_if(entries, [&](const PropertyEntry& entry) {
    const auto kind = std::find_if(kKeyLimits.begin(), kKeyLimits.end(), [&](const KeyLimit& k) {
      return entry.key.starts_with(k.prefix);
    });
    if (kind == kKeyLimits.end()) return false;
    const std::size_t count = ++counts[static_cast<std::size_t>(kind - kKeyLimits.begin())];
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
