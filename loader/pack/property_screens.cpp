// Screens, sliders, feature flags and profiles. Contract: properties.csv, options.csv profile.*.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "pack/features.h"
#include "pack/property_keys.h"
#include "pack/text.h"

namespace orris {
namespace {

std::vector<std::string> optionNames(const OptionSet& options) {
  std::vector<std::string> names;
  for (const auto& entry : options.all()) names.push_back(entry.first);
  return names;
}

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
  if (key == "iris.features.optional") context.out.optionalFeatures = flags();
  if (key == "orris.features.optional") context.out.orrisOptionalFeatures = flags();
  if (key == "iris.features.required") {
    context.out.requiredFeatures = flags();
    requireFeatures(context, supportedFeatures());
  }
  if (key == "orris.features.required") {
    context.out.orrisRequiredFeatures = flags();
    requireFeatures(context, supportedOrrisFeatures());
  }
}

/// Profiles by name, so that parents are found in any order.
class ProfileReader {
 public:
  ProfileReader(const std::vector<PropertyEntry>& entries, ShaderProperties& out,
                const OptionSet& options, Diagnostics& diagnostics)
      : out_(out), options_(options), diagnostics_(diagnostics) {
    for (const PropertyEntry& entry : entries) {
      if (!entry.key.starts_with(kPrefix)) continue;
      entries_.emplace(entry.key.substr(kPrefix.size()), &entry);
      order_.push_back(entry.key.substr(kPrefix.size()));
    }
  }

  void readAll() {
    for (const std::string& name : order_) {
      const PropertyEntry& entry = *entries_.at(name);
      Profile profile{.name = name, .at = entry.at};
      open_ = {name};
      words_ = 0;
      apply(entry, profile);
      out_.profiles.push_back(std::move(profile));
    }
  }

 private:
  static constexpr std::string_view kPrefix = "profile.";
  static constexpr std::string_view kProgram = "!program.";
  // Parents may be named often, so the work can grow exponentially with their number.
  static constexpr size_t kMostWords = 100'000;
  static constexpr size_t kDeepest = 64;

  void apply(const PropertyEntry& entry, Profile& profile) {
    for (const std::string& word : splitBlanks(entry.value)) {
      if (++words_ > kMostWords) return;
      applyWord({out_, entry, options_, diagnostics_}, word, profile);
    }
  }

  void applyWord(const PropertyContext& context, const std::string& word, Profile& profile) {
    const size_t split = std::min(
        word.find('='), word.find('=') == std::string::npos ? word.find(':') : word.size());
    if (word.starts_with(kProgram)) {
      profile.disabledPrograms.push_back(word.substr(kProgram.size()));
    } else if (word.starts_with(kPrefix)) {
      applyParent(context, word.substr(kPrefix.size()), profile);
    } else if (word.starts_with('!')) {
      set(context, word.substr(1), "false", profile);
    } else if (split != std::string::npos) {
      set(context, word.substr(0, split), word.substr(split + 1), profile);
    } else if (const Option* option = options_.find(word); option && option->isBoolean) {
      set(context, word, "true", profile);
    } else {
      context.warn("profile-option",
                   option ? fmt::format("{} has values, so it needs one here", word)
                          : fmt::format("the pack has no option {}", word),
                   option ? fmt::format("write {}={}", word, option->defaultValue)
                          : suggest(word, optionNames(options_)),
                   word);
    }
  }

  void applyParent(const PropertyContext& context, const std::string& parent, Profile& profile) {
    const auto found = entries_.find(parent);
    if (found == entries_.end()) {
      std::vector<std::string> names = order_;
      context.fail("profile-unknown", fmt::format("there is no profile {}", parent),
                   suggest(parent, names), "profile." + parent);
    } else if (open_.size() > kDeepest ||
               std::find(open_.begin(), open_.end(), parent) != open_.end()) {
      reportRecursion(context, parent);
    } else {
      open_.push_back(parent);
      apply(*found->second, profile);
      open_.pop_back();
    }
  }

  /// Each circle once, whichever of its profiles is read first.
  void reportRecursion(const PropertyContext& context, const std::string& parent) {
    std::vector<std::string> circle(std::find(open_.begin(), open_.end(), parent), open_.end());
    const std::string path = fmt::format("{} -> {}", fmt::join(circle, " -> "), parent);
    std::sort(circle.begin(), circle.end());
    if (!circles_.insert(circle).second) return;
    context.fail("profile-recursion", "profiles include each other: " + path, "",
                 "profile." + parent);
  }

  void set(const PropertyContext& context, const std::string& name, const std::string& value,
           Profile& profile) {
    if (!options_.find(name)) {
      context.warn("profile-option", fmt::format("the pack has no option {}", name),
                   suggest(name, optionNames(options_)), name);
      return;
    }
    profile.values[name] = value;
  }

  ShaderProperties& out_;
  const OptionSet& options_;
  Diagnostics& diagnostics_;
  std::map<std::string, const PropertyEntry*> entries_;
  std::vector<std::string> order_;
  std::vector<std::string> open_;
  std::set<std::vector<std::string>> circles_;
  size_t words_ = 0;
};

/// Names on screens and in the slider list that are no option and no keyword.
void checkScreens(const std::vector<PropertyEntry>& entries, const ShaderProperties& out,
                  const OptionSet& options, Diagnostics& diagnostics) {
  const auto isScreen = [&](const std::string& name) {
    return std::any_of(out.screens.begin(), out.screens.end(),
                       [&](auto& s) { return s.name == name; });
  };
  for (const PropertyEntry& entry : entries) {
    const bool screen = entry.key == "screen" ||
                        (entry.key.starts_with("screen.") && !entry.key.ends_with(".columns"));
    if (!screen) continue;
    for (const std::string& word : splitBlanks(entry.value)) {
      if (word == "*" || word == "<profile>" || word == "<empty>" || options.find(word)) continue;
      const bool link = word.size() > 2 && word.front() == '[' && word.back() == ']';
      if (link && isScreen(word.substr(1, word.size() - 2))) continue;
      diagnostics.push_back(
          propertyDiagnostic(Severity::Warning, "screen-option", entry,
                             (link ? "there is no screen " : "the pack has no option ") + word,
                             link ? "" : suggest(word, optionNames(options)), word));
    }
  }
}

}  // namespace

void readScreens(const std::vector<PropertyEntry>& entries, ShaderProperties& out,
                 const OptionSet& options, Diagnostics& diagnostics) {
  for (const PropertyEntry& entry : entries) {
    if (readScreenKey({out, entry, options, diagnostics})) continue;
    if (entry.key == "sliders") out.sliders = splitBlanks(entry.value);
    readFeatures({out, entry, options, diagnostics});
  }
  checkScreens(entries, out, options, diagnostics);
}

void readProfiles(const std::vector<PropertyEntry>& entries, ShaderProperties& out,
                  const OptionSet& options, Diagnostics& diagnostics) {
  ProfileReader(entries, out, options, diagnostics).readAll();
}

}  // namespace orris
