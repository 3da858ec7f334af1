#include <orris/check/options/screen_checks.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include <orris/check/pack/pack_texts.h>
#include <orris/core/limits.h>
#include <orris/pack/files/text.h>
#include <orris/pack/programs/program_id.h>

namespace orris {
namespace {

constexpr std::string_view kScreen = "screen.";
constexpr std::string_view kColumns = ".columns";

/// What no longer exists is left over and harmless; what nearly exists was misspelt.
Severity severityOf(const std::string& meant) {
  return meant.empty() ? Severity::Note : Severity::Warning;
}
std::string hintFor(const std::string& meant) {
  return meant.empty() ? "" : fmt::format("did you mean {}?", meant);
}

/// Names of the screens that have entries of their own.
std::set<std::string> screenNames(const std::vector<PropertyEntry>& entries) {
  std::set<std::string> names;
  for (const PropertyEntry& entry : entries) {
    if (isScreenKey(entry.key) && entry.key != "screen")
      names.insert(entry.key.substr(kScreen.size()));
  }
  return names;
}

std::set<std::string> linkedScreens(const std::vector<PropertyEntry>& entries) {
  std::set<std::string> links;
  for (const PropertyEntry& entry : entries) {
    if (!isScreenKey(entry.key)) continue;
    for (const std::string& word : splitBlanks(entry.value)) {
      if (word.size() > 2 && word.front() == '[' && word.back() == ']') {
        links.insert(word.substr(1, word.size() - 2));
      }
    }
  }
  return links;
}

void checkColumns(const PropertyEntry& entry, const std::set<std::string>& names,
                  std::size_t& hints, Diagnostics& diagnostics) {
  if (!entry.key.starts_with(kScreen) || !entry.key.ends_with(kColumns)) return;
  const std::string key = entry.key;
  if (key.size() <= kScreen.size() + kColumns.size()) return;
  const std::string name =
      key.substr(kScreen.size(), key.size() - kScreen.size() - kColumns.size());
  if (names.contains(name)) return;
  const bool late = hints++ >= limits::kSuggestions;
  const std::string meant = late ? "" : likelyMeant(name, {names.begin(), names.end()});
  diagnostics.push_back(propertyDiagnostic(severityOf(meant), "screen-columns", entry,
                                           fmt::format("there is no screen {}", name),
                                           hintFor(meant)));
}

/// Of each program file its path without the extension: "composite2", "world0/composite2".
std::vector<std::string> programPaths(const ShaderPack& pack) {
  std::set<std::string> names;
  for (const std::string& path : pack.source->files()) {
    const size_t dot = path.rfind('.');
    if (dot != std::string::npos && parseProgramFile(path)) names.insert(path.substr(1, dot - 1));
  }
  return {names.begin(), names.end()};
}

void checkDisabledPrograms(const PropertyEntry& entry, const std::vector<std::string>& programs,
                           std::size_t& hints, Diagnostics& diagnostics) {
  constexpr std::string_view kProgram = "!program.";
  for (const PropertyWord& word : locatedWords(entry)) {
    if (!word.text.starts_with(kProgram)) continue;
    const std::string name = word.text.substr(kProgram.size());
    if (std::binary_search(programs.begin(), programs.end(), name)) continue;
    const bool late = hints++ >= limits::kSuggestions;
    diagnostics.push_back(wordDiagnostic(Severity::Warning, "profile-program", word,
                                         fmt::format("the pack has no program {}", name),
                                         late ? "" : suggest(name, programs)));
  }
}

void reportEqualProfiles(const ShaderPack& pack, const std::vector<PropertyEntry>& entries,
                         Diagnostics& diagnostics) {
  using Effect = std::pair<OptionValues, std::vector<std::string>>;
  std::map<Effect, const Profile*> firsts;
  std::map<std::string_view, const PropertyEntry*> byKey;
  for (const PropertyEntry& entry : entries) byKey.emplace(entry.key, &entry);
  for (const Profile& profile : pack.properties.profiles) {
    const auto [first, isNew] =
        firsts.try_emplace({profile.values, profile.disabledPrograms}, &profile);
    if (isNew) continue;
    const auto entry = byKey.find("profile." + profile.name);
    if (entry == byKey.end()) continue;
    diagnostics.push_back(propertyDiagnostic(
        Severity::Note, "profile-same", *entry->second,
        fmt::format("profile {} sets the same as {}", profile.name, first->second->name),
        fmt::format("whoever chooses it is shown {} as the current one", first->second->name)));
  }
}

}  // namespace

void checkScreenLinks(std::span<const ShaderPack> folders, Diagnostics& diagnostics) {
  const auto entries = originalProperties(folders.front());
  const auto names = screenNames(entries), links = linkedScreens(entries);
  std::size_t hints = 0;
  const bool hasMain =
      std::any_of(entries.begin(), entries.end(), [](auto& e) { return e.key == "screen"; });
  for (const PropertyEntry& entry : entries) {
    checkColumns(entry, names, hints, diagnostics);
    const bool sub = isScreenKey(entry.key) && entry.key != "screen";
    if (!sub || !hasMain || links.contains(entry.key.substr(kScreen.size()))) continue;
    diagnostics.push_back(propertyDiagnostic(
        Severity::Note, "screen-unlinked", entry,
        fmt::format("no screen links to [{}]", entry.key.substr(kScreen.size()))));
  }
}

void checkSliders(std::span<const ShaderPack> folders, Diagnostics& diagnostics) {
  const ShaderPack& pack = folders.front();
  const std::set<std::string> sliders(pack.properties.sliders.begin(),
                                      pack.properties.sliders.end());
  std::vector<std::string> others;
  for (const auto& [name, option] : pack.options.all()) {
    if (!sliders.contains(name)) others.push_back(name);
  }
  std::size_t hints = 0;
  for (const PropertyEntry& entry : originalProperties(pack)) {
    if (entry.key != "sliders") continue;
    for (const PropertyWord& word : locatedWords(entry)) {
      if (pack.options.find(word.text)) continue;
      const bool late = hints++ >= limits::kSuggestions;
      const std::string meant =
          late || pack.options.rejected(word.text) ? "" : likelyMeant(word.text, others);
      diagnostics.push_back(wordDiagnostic(severityOf(meant), "slider-option", word,
                                           fmt::format("the pack has no option {}", word.text),
                                           hintFor(meant)));
    }
  }
}

void checkProfiles(std::span<const ShaderPack> folders, Diagnostics& diagnostics) {
  const ShaderPack& pack = folders.front();
  const auto entries = originalProperties(pack);
  const auto programs = programPaths(pack);
  std::size_t hints = 0;
  const auto isProfile = [](const PropertyEntry& e) { return e.key.starts_with("profile."); };
  for (const PropertyEntry& entry : entries) {
    if (isProfile(entry)) checkDisabledPrograms(entry, programs, hints, diagnostics);
  }
  reportEqualProfiles(pack, entries, diagnostics);
  const bool offered = std::any_of(entries.begin(), entries.end(), [](const PropertyEntry& entry) {
    return isScreenKey(entry.key) && entry.value.find("<profile>") != std::string::npos;
  });
  const bool hasScreens =
      std::any_of(entries.begin(), entries.end(), [](auto& e) { return isScreenKey(e.key); });
  const auto first = std::find_if(entries.begin(), entries.end(), isProfile);
  if (offered || !hasScreens || first == entries.end()) return;
  diagnostics.push_back(propertyDiagnostic(Severity::Note, "profile-hidden", *first,
                                           "no screen holds <profile>, so nobody can choose one"));
}

}  // namespace orris
