#include "check/property_checks.h"

#include <fmt/format.h>

#include <map>

#include "check/pack_texts.h"
#include "glsl/preprocessor.h"
#include "pack/text.h"

namespace orris {
namespace {

constexpr const char* kFile = "/shaders.properties";

/// Read without preprocessing, so that every branch counts. Contract: profile.nocond.
bool ignoresConditions(std::string_view key) {
  return key == "sliders" || key.starts_with("profile.") || key.starts_with("screen") ||
         key.starts_with("iris.features.") || key.starts_with("orris.features.");
}

void reportTwice(const std::vector<PropertyEntry>& entries, const Branches& branches,
                 bool unconditional, Diagnostics& diagnostics) {
  std::map<std::string_view, const PropertyEntry*> last;
  for (const PropertyEntry& entry : entries) {
    if (ignoresConditions(entry.key) != unconditional) continue;
    const auto [before, isNew] = last.try_emplace(entry.key, &entry);
    if (isNew) continue;
    const PropertyEntry& first = *before->second;
    before->second = &entry;
    if (splitBlanks(first.value) == splitBlanks(entry.value)) continue;
    // A default before the #if that changes it is no slip.
    if (!unconditional && !branches.implies(first.at.line, entry.at.line)) continue;
    // Custom uniforms have a diagnostic of their own, as the first of two counts.
    if (entry.key.starts_with("uniform.") || entry.key.starts_with("variable.")) continue;
    diagnostics.push_back(propertyDiagnostic(
        Severity::Warning, "property-twice", entry,
        fmt::format("{} is given again, so its value in line {} is lost", entry.key, first.at.line),
        unconditional ? "for this key #if lines count for nothing: of all lines the last one counts"
                      : "the last line of a key counts"));
  }
}

}  // namespace

void checkPropertiesTwice(std::span<const ShaderPack> folders, Diagnostics& diagnostics) {
  const ShaderPack& pack = folders.front();
  const auto text = pack.source->read(kFile);
  if (!text) return;
  Diagnostics told;
  const std::string active = preprocessProperties(kFile, *text, pack.propertyMacros, told);
  const Branches branches(*text);
  reportTwice(parseProperties(kFile, active, Continuation::Preprocessed, *text), branches, false,
              diagnostics);
  reportTwice(parseProperties(kFile, *text, Continuation::Java), branches, true, diagnostics);
}

}  // namespace orris
