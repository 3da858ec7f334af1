// Screens, sliders and feature flags. Contract: properties.csv.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include <orris/core/limits.h>
#include <orris/pack/files/text.h>
#include <orris/pack/properties/property_keys.h>
#include <orris/pack/versions/features.h>

namespace orris {
namespace {

Screen& screenNamed(ShaderProperties& out, std::string_view name, const SourceLocation& at) {
  auto& screens = out.screens;
  const auto found =
      std::find_if(screens.begin(), screens.end(), [&](auto& s) { return s.name == name; });
  if (found != screens.end()) return *found;
  return screens.emplace_back(Screen{.name = std::string(name), .at = at});
}

void readColumns(const PropertyContext& context, std::string_view name) {
  const auto columns = parseInteger(trim(context.entry.value));
  if (columns && *columns > 0 && *columns <= 32) {
    screenNamed(context.out, name, context.entry.at).columns = static_cast<int>(*columns);
  } else {
    context.warn("property-value", fmt::format("{} is \"{}\", expected a number from 1 to 32",
                                               context.entry.key, context.entry.value));
  }
}

void readScreen(const PropertyContext& context, std::string_view name) {
  Screen& screen = screenNamed(context.out, name, context.entry.at);
  screen.at = context.entry.at;
  screen.entries = splitBlanks(context.entry.value);
}

/// Reads the key if it is one of a screen; the name is "" for the main screen.
bool readScreenKey(const PropertyContext& context) {
  constexpr std::string_view kColumns = ".columns";
  const std::string_view key = context.entry.key;
  if (key == "screen.columns") return readColumns(context, ""), true;
  if (key == "screen") return readScreen(context, ""), true;
  if (!key.starts_with("screen.")) return false;
  const std::string_view name = key.substr(7);
  if (name.ends_with(kColumns)) {
    readColumns(context, name.substr(0, name.size() - kColumns.size()));
  } else {
    readScreen(context, name);
  }
  return true;
}

void readFeatures(const PropertyContext& context) {
  const std::string& key = context.entry.key;
  const auto flags = [&] { return splitBlanks(upperCase(context.entry.value)); };
  if (key == "iris.features.optional") {
    context.out.optionalFeatures = flags();
    context.out.optionalAsWritten = splitBlanks(context.entry.value);
    warnOfFlagCase(context);
  }
  if (key == "orris.features.optional") context.out.orrisOptionalFeatures = flags();
  if (key == "iris.features.required") {
    context.out.requiredFeatures = flags();
    requireFeatures(context, supportedFeatures(context.iris));
  }
  if (key == "orris.features.required") {
    context.out.orrisRequiredFeatures = flags();
    requireFeatures(context, supportedOrrisFeatures());
  }
}

/// In the order of the file, and to look up.
struct ScreenNames {
  std::vector<std::string> list;
  std::set<std::string> set;
};

/// "<empty>OPTION".
bool gluedToKeyword(const std::string& text) {
  const size_t end = text.find('>');
  return text.starts_with('<') && end != std::string::npos && end + 1 < text.size();
}

/// A word on a screen that is no option, keyword or link to a screen.
void checkScreenWord(const PropertyWord& word, const ScreenNames& screens, const OptionSet& options,
                     size_t& hints, Diagnostics& diagnostics) {
  const std::string& text = word.text;
  static const std::vector<std::string> kKeywords{"*", "<profile>", "<empty>"};
  if (options.find(text) || std::find(kKeywords.begin(), kKeywords.end(), text) != kKeywords.end())
    return;
  const bool link = text.size() > 2 && text.front() == '[' && text.back() == ']';
  const std::string name = link ? text.substr(1, text.size() - 2) : text;
  if (link && screens.set.contains(name)) return;
  const std::string hint = hints++ >= limits::kSuggestions ? ""
                           : link                          ? suggest(name, screens.list)
                           : gluedToKeyword(text)          ? "a blank is missing after >"
                           : text.starts_with('<')         ? suggest(text, kKeywords)
                                                           : missingOptionHint(options, text);
  // A link to nothing is a label, as packs use it.
  diagnostics.push_back(wordDiagnostic(
      link && hint.empty() ? Severity::Note : Severity::Warning, "screen-option", word,
      (link ? "there is no screen " : "the pack has no option ") + text, hint));
}

void checkScreens(const std::vector<PropertyEntry>& entries, const ShaderProperties& out,
                  const OptionSet& options, Diagnostics& diagnostics) {
  ScreenNames screens;
  size_t hints = 0;
  for (const Screen& screen : out.screens) screens.list.push_back(screen.name);
  screens.set.insert(screens.list.begin(), screens.list.end());
  for (const PropertyEntry& entry : entries) {
    const bool screen = entry.key == "screen" ||
                        (entry.key.starts_with("screen.") && !entry.key.ends_with(".columns"));
    if (!screen) continue;
    for (const PropertyWord& word : locatedWords(entry)) {
      checkScreenWord(word, screens, options, hints, diagnostics);
    }
  }
}

}  // namespace

void readScreens(const std::vector<PropertyEntry>& entries, ShaderProperties& out,
                 const OptionSet& options, const Version& iris, Diagnostics& diagnostics) {
  for (const PropertyEntry& entry : entries) {
    if (readScreenKey({out, entry, options, diagnostics})) continue;
    if (entry.key == "sliders") out.sliders = splitBlanks(entry.value);
    readFeatures({out, entry, options, diagnostics, iris});
  }
  checkScreens(entries, out, options, diagnostics);
}

}  // namespace orris
