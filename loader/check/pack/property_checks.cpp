#include <orris/check/pack/property_checks.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include <orris/check/pack/pack_texts.h>
#include <orris/core/files/text_file.h>
#include <orris/glsl/preprocess/preprocessor.h>
#include <orris/pack/files/text.h>
#include <orris/pack/properties/property_keys.h>

namespace orris {
namespace {

bool isExpression(std::string_view key) {
  return key.starts_with("uniform.") || key.starts_with("variable.");
}

constexpr const char* kFile = "/shaders.properties";

/// Read without preprocessing, so that every branch counts. Contract: profile.nocond.
bool ignoresConditions(std::string_view key) {
  return key == "sliders" || key.starts_with("profile.") || key.starts_with("screen") ||
         key.starts_with("iris.features.") || key.starts_with("orris.features.");
}

/// "// text": Iris takes it for a key, which nobody reads.
bool isMeantAsComment(const PropertyEntry& entry) { return entry.key.starts_with("//"); }

void reportSlashes(const std::vector<PropertyEntry>& entries, Diagnostics& diagnostics) {
  const auto first = std::ranges::find_if(entries, isMeantAsComment);
  if (first == entries.end()) return;
  const auto lines = std::ranges::count_if(entries, isMeantAsComment);
  diagnostics.push_back(propertyDiagnostic(
      Severity::Note, "property-comment", *first,
      fmt::format("{} line{} begin{} with //, which is a key that nothing reads, and no comment",
                  lines, lines == 1 ? "" : "s", lines == 1 ? "s" : ""),
      "# begins a comment"));
}

void reportTwice(const std::vector<PropertyEntry>& entries, const Branches& branches,
                 bool unconditional, Diagnostics& diagnostics) {
  std::map<std::string_view, const PropertyEntry*> last;
  for (const PropertyEntry& entry : entries) {
    if (ignoresConditions(entry.key) != unconditional) continue;
    // Nothing is lost of what nobody reads.
    if (!unconditional && !isKnownPropertyKey(entry.key)) continue;
    const auto [before, isNew] = last.try_emplace(entry.key, &entry);
    if (isNew) continue;
    const PropertyEntry& first = *before->second;
    before->second = &entry;
    if (splitBlanks(first.value) == splitBlanks(entry.value)) continue;
    // A default before the #if that changes it is no slip.
    if (!unconditional && !branches.implies(first.at.line, entry.at.line)) continue;
    // Custom uniforms have a diagnostic of their own, as the first of two counts.
    if (isExpression(entry.key)) continue;
    diagnostics.push_back(propertyDiagnostic(
        Severity::Warning, "property-twice", entry,
        fmt::format("{} is given again, so its value in line {} is lost", entry.key, first.at.line),
        unconditional ? "for this key #if lines count for nothing: of all lines the last one counts"
                      : "the last line of a key counts"));
    diagnostics.back().related.push_back({first.at, "the line whose value is lost"});
  }
}

bool isList(std::string_view key) {
  return key == "sliders" || key.starts_with("profile.") || isScreenKey(key) || isExpression(key);
}

/// Is the line a piece of `list` rather than a key: options, links, marks of screens?
bool isPieceOf(const PropertyEntry& list, std::string_view line, const OptionSet& options) {
  // No expression ends so.
  constexpr std::string_view kOpenEnds = ",(+-*/%&|<>=!";
  const std::string_view value = trim(list.value);
  if (isExpression(list.key)) return !value.empty() && kOpenEnds.find(value.back()) != value.npos;
  std::string_view word = trim(line);
  word = word.substr(0, word.find_first_of(" \t"));
  if (word.starts_with('<') || word.starts_with('[') || word == "*") return true;
  const bool ofProfile = list.key.starts_with("profile.");
  const bool hasSign = trim(line).find_first_of("=:") != std::string_view::npos;
  if (hasSign && !ofProfile) return false;
  return options.find(word.substr(0, word.find_first_of("=:"))) != nullptr;
}

/// Lines after one of a list that has lost its backslash.
void reportStray(const std::vector<PropertyEntry>& entries, const OptionSet& options,
                 Diagnostics& diagnostics) {
  const PropertyEntry *list = nullptr, *before = nullptr;
  for (const PropertyEntry& entry : entries) {
    const bool next =
        before && entry.at.line == before->at.line + static_cast<int>(before->lines.size());
    before = &entry;
    if (isList(entry.key)) {
      list = &entry;
    } else if (!list || !next || !isPieceOf(*list, entry.lines.front(), options)) {
      list = nullptr;
    } else {
      diagnostics.push_back(withEffect(
          propertyDiagnostic(Severity::Warning, "property-stray-line", entry,
                             fmt::format("this line is no part of {}: the line before it does not "
                                         "end in a backslash",
                                         list->key),
                             "end the line before it with a backslash"),
          Effect::IgnoresLine));
      if (isExpression(list->key)) list = nullptr;
    }
  }
}

}  // namespace

void checkStrayLines(std::span<const ShaderPack> folders, Diagnostics& diagnostics) {
  const ShaderPack& pack = folders.front();
  const auto text = pack.source->read(kFile);
  if (!text) return;
  const std::vector<PropertyEntry> entries = parseProperties(kFile, *text, Continuation::Java);
  reportStray(entries, pack.options, diagnostics);
  reportSlashes(entries, diagnostics);
}

void checkPropertiesTwice(std::span<const ShaderPack> folders, Diagnostics& diagnostics) {
  const ShaderPack& pack = folders.front();
  const auto text = readText(*pack.source, kFile);
  if (!text) return;
  Diagnostics reported;
  const std::string active = preprocessProperties(kFile, *text, pack.propertyMacros, reported);
  const Branches branches(*text);
  reportTwice(parseProperties(kFile, active, Continuation::Preprocessed, *text), branches, false,
              diagnostics);
  reportTwice(parseProperties(kFile, *text, Continuation::Java), branches, true, diagnostics);
}

}  // namespace orris
