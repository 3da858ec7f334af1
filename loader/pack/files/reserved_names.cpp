#include <orris/pack/files/reserved_names.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <string_view>

namespace orris {
namespace {

constexpr std::array<std::string_view, 3> kReservedPrefixes{"iris_", "irisMain", "moj_import"};

}  // namespace

void checkReservedNames(const TokenStream& stream, Diagnostics& diagnostics) {
  std::set<std::string_view> seen;
  for (const Token& token : stream.tokens) {
    if (token.kind != TokenKind::Identifier) continue;
    const auto* prefix = std::ranges::find_if(
        kReservedPrefixes, [&](std::string_view start) { return token.text.starts_with(start); });
    if (prefix == kReservedPrefixes.end() || !seen.insert(token.text).second) continue;
    diagnostics.push_back(withEffect(
        {.severity = Severity::Error,
         .id = "name-reserved",
         .at = locate(stream.sites, token.origin),
         .message = fmt::format("{} begins with {}, as Iris's own names do", token.text, *prefix),
         .includedFrom = includedFrom(stream.sites, token.origin.site),
         .hint = "choose another name"},
        Effect::RefusesProgram));
  }
}

}  // namespace orris
