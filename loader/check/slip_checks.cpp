#include "check/slip_checks.h"

#include <fmt/format.h>

#include <algorithm>

#include "check/pack_texts.h"

namespace orris {
namespace {

Diagnostic slip(std::string id, SourceLocation at, std::string_view line, std::string message,
                const std::string& meant) {
  Diagnostic d;
  d.severity = Severity::Warning;
  d.id = std::move(id);
  d.at = std::move(at);
  d.sourceLine = line;
  d.message = std::move(message);
  d.hint = fmt::format("did you mean {}?", meant);
  return d;
}

void checkConditionNames(const PropertyEntry& entry, const std::vector<std::string>& options,
                         Diagnostics& diagnostics) {
  forEachWord(entry.value, [&](std::string_view word) {
    if (std::ranges::find(options, word) != options.end()) return;
    const std::string meant = likelyMeant(word, options);
    if (meant.empty()) return;
    diagnostics.push_back(slip("program-condition", entry.at, entry.lines.front(),
                               fmt::format("the pack has no option {}", word), meant));
  });
}

}  // namespace

void checkPropertyNames(std::span<const ShaderPack> folders, Diagnostics& diagnostics) {
  const ShaderPack& pack = folders.front();
  std::vector<std::string> options;
  for (const auto& option : pack.options.all()) options.push_back(option.first);
  constexpr std::string_view kProgram = "program.", kEnabled = ".enabled";
  for (const PropertyEntry& entry : originalProperties(pack)) {
    if (entry.lines.empty()) continue;
    const std::string_view key = entry.key;
    if (!key.starts_with(kProgram) || !key.ends_with(kEnabled)) continue;
    if (key.size() <= kProgram.size() + kEnabled.size()) continue;
    checkConditionNames(entry, options, diagnostics);
  }
}

}  // namespace orris
