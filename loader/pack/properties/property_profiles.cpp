// Profiles. Contract: options.csv profile.*.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include <orris/core/limits.h>
#include <orris/pack/files/text.h>
#include <orris/pack/properties/property_keys.h>

namespace orris {
namespace {

/// Of a number the values beside it, of a word the one that is spelt like it.
std::string nearestValues(const std::string& value, const std::vector<std::string>& values) {
  const auto number = parseFloat(value);
  if (!number) return suggest(value, values);
  const std::string *below = nullptr, *above = nullptr;
  for (const std::string& candidate : values) {
    const auto other = parseFloat(candidate);
    if (!other) continue;
    if (*other <= *number && (!below || *other > *parseFloat(*below))) below = &candidate;
    if (*other >= *number && (!above || *other < *parseFloat(*above))) above = &candidate;
  }
  if (!below || !above) return "";
  if (*below == *above) return fmt::format("write it as its list does: {}", *below);
  return fmt::format("the values beside it are {} and {}", *below, *above);
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
      taken_.clear();
      repeated_.clear();
      apply(entry, profile);
      out_.profiles.push_back(std::move(profile));
    }
  }

 private:
  static constexpr std::string_view kPrefix = "profile.";
  static constexpr std::string_view kProgram = "!program.";
  static constexpr size_t kMostPlaces = 20;

  // Parents may be named often, so the work can grow exponentially with their number.
  void apply(const PropertyEntry& entry, Profile& profile) {
    for (const PropertyWord& word : wordsOf(entry)) {
      if (++words_ == limits::kProfileWords + 1) {
        report(Severity::Error, "property-limit", word,
               fmt::format("with its parents, profile {} has more than {} words; the rest is left "
                           "out",
                           profile.name, limits::kProfileWords),
               "");
      }
      if (words_ > limits::kProfileWords) return;
      applyWord(word, profile);
    }
  }

  /// Parents may be named often: their words are placed once.
  const std::vector<PropertyWord>& wordsOf(const PropertyEntry& entry) {
    const auto [found, isNew] = placed_.try_emplace(&entry);
    if (isNew) found->second = locatedWords(entry);
    return found->second;
  }

  void applyWord(const PropertyWord& at, Profile& profile) {
    const std::string& word = at.text;
    const size_t split = std::min(
        word.find('='), word.find('=') == std::string::npos ? word.find(':') : word.size());
    if (word.starts_with(kProgram)) {
      profile.disabledPrograms.push_back(word.substr(kProgram.size()));
    } else if (word.starts_with(kPrefix)) {
      applyParent(at, word.substr(kPrefix.size()), profile);
    } else if (word.starts_with('!')) {
      setOption(at, word.substr(1), "false", profile);
    } else if (split != std::string::npos) {
      setOption(at, word.substr(0, split), word.substr(split + 1), profile);
    } else if (const Option* option = options_.find(word); option && option->isBoolean) {
      setOption(at, word, "true", profile);
    } else {
      if (!option) return reportUnknownOption(at, word);
      report(Severity::Warning, "profile-option", at,
             fmt::format("{} has values, so it needs one here", word),
             fmt::format("write {}={}", word, option->defaultValue));
    }
  }

  void applyParent(const PropertyWord& at, const std::string& parent, Profile& profile) {
    const auto found = entries_.find(parent);
    if (found == entries_.end()) {
      report(Severity::Error, "profile-unknown", at, fmt::format("there is no profile {}", parent),
             hints_++ < limits::kSuggestions ? suggest(parent, order_) : "");
    } else if (std::find(open_.begin(), open_.end(), parent) != open_.end()) {
      reportRecursion(at, parent);
    } else if (open_.size() > limits::kProfileDepth) {
      report(Severity::Error, "property-limit", at,
             fmt::format("profiles are nested deeper than {} parents here", limits::kProfileDepth),
             "");
    } else {
      if (!taken_.insert(parent).second && repeated_.insert(parent).second)
        reportRepeated(at, parent);
      open_.push_back(parent);
      apply(*found->second, profile);
      open_.pop_back();
    }
  }

  void reportRepeated(const PropertyWord& at, const std::string& parent) {
    report(Severity::Warning, "profile-repeated", at,
           fmt::format("{} reaches profile {} a second time", open_.front(), parent),
           "Iris takes that for a circle and refuses the pack");  // Iris: ProfileSet.parse
  }

  /// Each circle once, whichever of its profiles is read first.
  void reportRecursion(const PropertyWord& at, const std::string& parent) {
    std::vector<std::string> circle(std::find(open_.begin(), open_.end(), parent), open_.end());
    const std::string path = fmt::format("{} -> {}", fmt::join(circle, " -> "), parent);
    std::sort(circle.begin(), circle.end());
    if (!circles_.insert(circle).second) return;
    report(Severity::Error, "profile-recursion", at, "profiles include each other: " + path, "");
  }

  void setOption(const PropertyWord& at, const std::string& name, const std::string& value,
                 Profile& profile) {
    const Option* option = options_.find(name);
    if (option) {
      profile.values[name] = value;
    } else if (name.empty()) {
      report(Severity::Warning, "profile-option", at,
             fmt::format("\"{}\" names no option", at.text), "write NAME=VALUE, NAME or !NAME");
    } else {
      profile.unknownNames.insert(name);
      reportUnknownOption(at, name);
    }
    if (option &&
        std::find(option->values.begin(), option->values.end(), value) == option->values.end()) {
      const std::string hint =
          hints_++ < limits::kSuggestions ? nearestValues(value, option->values) : "";
      report(Severity::Warning, "profile-value", at,
             fmt::format("{} is not in the list of {}", value, name),
             hint.empty() ? "its values are " + joinNames(option->values) : hint);
    }
  }

  /// Once for all profiles: the other places are added.
  void reportUnknownOption(const PropertyWord& at, const std::string& name) {
    const auto [known, isNew] = unknown_.try_emplace(name, diagnostics_.size());
    if (isNew)
      return report(Severity::Warning, "profile-option", at,
                    fmt::format("the pack has no option {}", name), optionHint(name));
    Diagnostic& first = diagnostics_[known->second];
    const bool listed =
        first.at == at.at || std::ranges::find(first.related, at.at, &RelatedPlace::at) != first.related.end();
    if (!listed && first.related.size() < kMostPlaces) first.related.push_back({at.at, "named here too"});
  }

  std::string optionHint(const std::string& name) {
    if (name.find('!') != std::string::npos) return "a blank is missing before !";
    return hints_++ < limits::kSuggestions ? missingOptionHint(options_, name) : "";
  }

  /// A word of a parent is reported once, however many profiles reach it.
  void report(Severity severity, std::string id, const PropertyWord& at, std::string message,
              std::string hint) {
    if (!reported_.emplace(id, at.at.line, at.at.column, message).second) return;
    diagnostics_.push_back(
        wordDiagnostic(severity, std::move(id), at, std::move(message), std::move(hint)));
  }

  ShaderProperties& out_;
  const OptionSet& options_;
  Diagnostics& diagnostics_;
  std::map<std::string, const PropertyEntry*> entries_;
  std::vector<std::string> order_;
  std::vector<std::string> open_;
  std::set<std::string> taken_;     ///< parents of the profile that is being read
  std::set<std::string> repeated_;  ///< those of them that were named again
  std::set<std::tuple<std::string, int, int, std::string>> reported_;
  std::map<std::string, size_t> unknown_;  ///< options that are none: the diagnostics
  size_t hints_ = 0;
  std::set<std::vector<std::string>> circles_;
  std::map<const PropertyEntry*, std::vector<PropertyWord>> placed_;
  size_t words_ = 0;
};

}  // namespace

void readProfiles(const std::vector<PropertyEntry>& entries, ShaderProperties& out,
                  const OptionSet& options, Diagnostics& diagnostics) {
  ProfileReader(entries, out, options, diagnostics).readAll();
}

}  // namespace orris
