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

void checkProgramName(const PropertyEntry& entry, std::string_view program,
                      Diagnostics& diagnostics) {
  static const std::vector<std::string> kPasses{"setup",   "begin",    "shadow",    "shadowcomp",
                                                "prepare", "deferred", "composite", "final"};
  program = program.substr(program.rfind('/') + 1);
  const size_t digits = program.find_first_of("0123456789");
  const std::string stem(program.substr(0, digits));
  if (std::ranges::find(kPasses, stem) != kPasses.end()) return;
  const std::string meant = likelyMeant(stem, kPasses);
  if (meant.empty()) return;
  diagnostics.push_back(slip("program-unknown", entry.at, entry.lines.front(),
                             fmt::format("no program is called {}", program), meant));
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
    checkProgramName(entry,
                     key.substr(kProgram.size(), key.size() - kProgram.size() - kEnabled.size()),
                     diagnostics);
    checkConditionNames(entry, options, diagnostics);
  }
}

}  // namespace orris
