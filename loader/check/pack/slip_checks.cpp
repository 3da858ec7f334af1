#include <orris/check/pack/slip_checks.h>

#include <fmt/format.h>

#include <algorithm>

#include <orris/check/pack/pack_texts.h>
#include <orris/pack/files/text.h>

namespace orris {
namespace {

Diagnostic slip(std::string id, SourceLocation at, std::string_view line, std::string message,
                const std::string& meant) {
  return {.severity = Severity::Warning,
          .id = std::move(id),
          .at = std::move(at),
          .message = std::move(message),
          .sourceLine = std::string(line),
          .hint = fmt::format("did you mean {}?", meant)};
}

void checkEntryCondition(const PropertyEntry& entry, const std::vector<std::string>& options,
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

void checkMacroNames(std::span<const ShaderPack> folders, Diagnostics& diagnostics) {
  constexpr std::string_view kMesa = "MC_GL_VENDOR_MESA";
  for (const auto& [file, lines] : folders.front().files) {
    for (size_t i = 0; i < lines.size(); ++i) {
      const size_t at = lines[i].find(kMesa);
      if (at == std::string::npos || !trim(lines[i]).starts_with("#")) continue;
      diagnostics.push_back(
          {.severity = Severity::Warning,
           .id = "macro-never",
           .at = {file, static_cast<int>(i) + 1, static_cast<int>(at) + 1},
           .message =
               fmt::format("Iris never defines {}: with Mesa it defines MC_GL_VENDOR_OTHER", kMesa),
           .sourceLine = lines[i],
           .hint = "ask for MC_GL_RENDERER_MESA, MC_GL_RENDERER_GALLIUM or MC_GL_VENDOR_OTHER"});
      return;
    }
  }
}

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
    checkEntryCondition(entry, options, diagnostics);
  }
}

}  // namespace orris
