#include <orris/check/options/language_checks.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <regex>
#include <set>
#include <span>

#include <orris/check/pack/pack_texts.h>
#include <orris/core/limits.h>
#include <orris/core/files/text_file.h>
#include <orris/pack/files/text.h>

namespace orris {
namespace {

using Names = std::set<std::string, std::less<>>;

/// Of many findings of one file, how many are listed.
constexpr size_t kMostListed = 20;

/// "option.SSAO.comment" is {"option", "SSAO", "", true}; "value.MODE.0.5" is {"value", "MODE",
/// "0.5"}.
struct LanguageKey {
  std::string kind, name, value;
  bool comment = false;

  /// What names are compared among: a comment says nothing about whether there is a title.
  std::string group() const { return kind + (comment ? ".comment" : ""); }
};

const std::vector<std::string>& kinds() {
  static const std::vector<std::string> kKinds{"option", "value",  "screen",
                                               "prefix", "suffix", "profile"};
  return kKinds;
}

LanguageKey splitKey(std::string key) {
  constexpr std::string_view kComment = ".comment";
  const bool comment = key.ends_with(kComment);
  if (comment) key.resize(key.size() - kComment.size());
  const size_t dot = key.find('.');
  if (dot == std::string::npos) return {key, "", "", comment};
  LanguageKey split{key.substr(0, dot), key.substr(dot + 1), "", comment};
  const size_t second = split.name.find('.');
  if (split.kind == "value" && second != std::string::npos) {
    split.value = split.name.substr(second + 1);
    split.name.resize(second);
  }
  return split;
}

std::vector<std::string> languageFiles(const ShaderPack& pack) {
  std::vector<std::string> files;
  for (const std::string& path : pack.source->files()) {
    const std::string lower = lowerCase(path);
    if (lower.starts_with("/lang/") && lower.ends_with(".lang") && lower.find('/', 6) == lower.npos)
      files.push_back(path);
  }
  return files;
}

std::vector<PropertyEntry> readLanguageFile(const ShaderPack& pack, const std::string& path) {
  return parseProperties(path, readText(*pack.source, path).value_or(""), Continuation::Java);
}

/// What a pack has, by the kind of its language keys.
std::map<std::string, Names> optionNames(const ShaderPack& pack) {
  std::map<std::string, Names> known;
  for (const auto& [name, option] : pack.options.all()) {
    for (const char* kind : {"option", "value", "prefix", "suffix"}) known[kind].insert(name);
  }
  for (const Screen& screen : pack.properties.screens) {
    known["screen"].insert(screen.name);
    // A link shows its text, whether there is such a screen or not.
    for (const std::string& entry : screen.entries) {
      if (entry.starts_with('[') && entry.ends_with(']'))
        known["screen"].insert(entry.substr(1, entry.size() - 2));
    }
  }
  for (const Profile& profile : pack.properties.profiles) known["profile"].insert(profile.name);
  return known;
}

/// Reports the keys of one file.
class FileCheck {
 public:
  FileCheck(const ShaderPack& pack, const std::map<std::string, Names>& known,
            std::vector<PropertyEntry> entries, Diagnostics& diagnostics)
      : pack_(pack), known_(known), entries_(std::move(entries)), diagnostics_(diagnostics) {
    for (const PropertyEntry& entry : entries_) {
      const LanguageKey key = splitKey(entry.key);
      translated_[key.group()].insert(key.name);
      if (key.kind == "value") translated_["value." + key.name].insert(key.value);
    }
  }

  void run() {
    for (const PropertyEntry& entry : entries_) {
      if (entry.key.starts_with("//")) continue;  // meant as a comment, and nobody reads it
      checkTwice(entry);
      checkKey(entry, splitKey(entry.key));
    }
    reportTwice();
    reportStale();
  }

 private:
  void checkTwice(const PropertyEntry& entry) {
    const auto [first, isNew] = first_.try_emplace(entry.key, &entry);
    if (isNew || trim(first->second->value) == trim(entry.value)) return;
    twice_.emplace_back(first->second, &entry);
  }

  /// Whole files are copied and translated: more than a few slips of a file are one finding.
  void reportTwice() {
    constexpr size_t kMostAlone = 3;
    for (const auto& [first, again] : twice_) {
      if (twice_.size() > kMostAlone) break;
      report(
          Severity::Warning, "language-twice", *again,
          fmt::format("{} has another text in line {}, which is lost", again->key, first->at.line));
    }
    if (twice_.size() <= kMostAlone) return;
    const auto& [first, again] = twice_.front();
    Diagnostic all = propertyDiagnostic(
        Severity::Warning, "language-twice", *again,
        fmt::format("{} and {} later lines of this file give keys another text, so that the "
                    "earlier one is lost",
                    again->key, twice_.size() - 1));
    for (const auto& [earlier, later] : twice_) {
      if (all.notes.size() == limits::kMessageNotes) break;
      all.notes.push_back(fmt::format("{}: line {}, before it line {}", later->key, later->at.line,
                                      earlier->at.line));
    }
    diagnostics_.push_back(std::move(all));
  }

  void checkKey(const PropertyEntry& entry, const LanguageKey& key) {
    // Iris shows profile.comment for each profile; other hosts have one of each.
    if (key.kind == "profile" && key.comment) return;
    const auto known = known_.find(key.kind);
    if (std::find(kinds().begin(), kinds().end(), key.kind) == kinds().end()) {
      const std::string meant = key.name.empty() ? "" : likelyMeant(key.kind, kinds());
      if (!meant.empty()) misspelt(entry, "kind of text ", key.kind, meant);
    } else if (!key.name.empty() && (known == known_.end() || !known->second.contains(key.name))) {
      checkUnknown(entry, key);
    } else if (key.kind == "value" && !key.value.empty()) {
      checkValue(entry, key);
    }
  }

  void checkUnknown(const PropertyEntry& entry, const LanguageKey& key) {
    const auto known = known_.find(key.kind);
    const bool late = hints_++ >= limits::kSuggestions;
    std::string meant =
        late || known == known_.end() || pack_.options.rejected(key.name)
            ? ""
            : likelyMeant(key.name, untranslated(known->second, translated_[key.group()]));
    if (meant.empty() && !late) meant = optionOfValue(key);
    const bool option = key.kind != "screen" && key.kind != "profile";
    const std::string noun = option ? "option" : key.kind;
    if (!meant.empty()) return misspelt(entry, noun + ' ', key.name, meant);
    const bool defined = option && pack_.options.rejected(key.name);
    anyGone_ = anyGone_ || !defined;
    stale_.emplace_back(
        &entry, fmt::format("the pack has no {} {}{}", noun, key.name,
                            defined ? ": " + missingOptionHint(pack_.options, key.name) : ""));
  }

  /// All of a file are one finding: they are what is left of options that are gone.
  void reportStale() {
    if (stale_.empty()) return;
    const auto& [entry, message] = stale_.front();
    const std::string others =
        stale_.size() < 2    ? ""
        : stale_.size() == 2 ? ", and one more line is for nothing"
                             : fmt::format(", and {} more lines are for nothing", stale_.size() - 1);
    report(Severity::Warning, "language-stale", *entry, message + others,
           anyGone_ ? "take lines away whose options are gone" : "");
    for (const auto& [other, reason] :
         std::span(stale_).subspan(1).first(std::min(stale_.size() - 1, kMostListed))) {
      diagnostics_.back().related.push_back({other->at, reason});
    }
  }

  /// The option that has such a value without a text, for a name that stands in no other line.
  std::string optionOfValue(const LanguageKey& key) {
    const bool onlyHere =
        translated_["value." + key.name].size() == 1 && !translated_["option"].contains(key.name);
    if (key.kind != "value" || key.comment || !onlyHere || pack_.options.rejected(key.name))
      return "";
    std::vector<std::string> options;
    for (const auto& [name, option] : pack_.options.all()) {
      const bool has = std::ranges::find(option.values, key.value) != option.values.end();
      if (has && !translated_["value." + name].contains(key.value)) options.push_back(name);
    }
    return likelyMeant(key.name, options);
  }

  void checkValue(const PropertyEntry& entry, const LanguageKey& key) {
    const Option& option = *pack_.options.find(key.name);
    const Names& values = valuesOf(option);
    if (values.contains(key.value)) return;
    const std::string meant =
        key.value.size() < 3 || hints_++ >= limits::kSuggestions
            ? ""
            : likelyMeant(key.value, untranslated(values, translated_["value." + key.name]));
    if (!meant.empty()) return misspelt(entry, "value ", key.value, meant);
    anyGone_ = true;
    stale_.emplace_back(&entry, fmt::format("{} has no value {}", key.name, key.value));
  }

  const Names& valuesOf(const Option& option) {
    Names& values = values_[option.name];
    if (values.empty()) values.insert(option.values.begin(), option.values.end());
    return values;
  }

  static std::vector<std::string> untranslated(const Names& names, const Names& translated) {
    std::vector<std::string> left;
    std::set_difference(names.begin(), names.end(), translated.begin(), translated.end(),
                        std::back_inserter(left));
    return left;
  }

  /// `noun`: what the name would be of, and a blank.
  void misspelt(const PropertyEntry& entry, const std::string& noun, const std::string& name,
                const std::string& meant) {
    report(Severity::Warning, "language-key", entry,
           fmt::format("the text of {} is used for nothing: there is no {}{}", entry.key, noun, name),
           fmt::format("did you mean {}?", meant));
  }

  void report(Severity severity, std::string id, const PropertyEntry& entry, std::string message,
              std::string hint = {}) {
    diagnostics_.push_back(
        propertyDiagnostic(severity, std::move(id), entry, std::move(message), std::move(hint)));
  }

  const ShaderPack& pack_;
  const std::map<std::string, Names>& known_;
  std::vector<PropertyEntry> entries_;
  Diagnostics& diagnostics_;
  std::map<std::string, Names> translated_;
  std::map<std::string, Names> values_;  ///< of each option that was asked for
  std::size_t hints_ = 0;
  std::map<std::string, const PropertyEntry*> first_;
  std::vector<std::pair<const PropertyEntry*, const PropertyEntry*>> twice_;
  std::vector<std::pair<const PropertyEntry*, std::string>> stale_;
  bool anyGone_ = false;  ///< is one of them of something that no line defines?
};

/// What the screens show and the English file has no text for.
class Missing {
 public:
  explicit Missing(Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

  void add(Diagnostic place, const std::string& key) {
    if (!keys_.insert(key).second) return;
    if (keys_.size() == 1) {
      place.message = "en_us.lang has no text for " + key;
      first_ = std::move(place);
    } else if (first_.notes.size() < kMostListed) {
      first_.notes.push_back(fmt::format("line {}: {}", place.at.line, key));
    }
  }

  void report() {
    if (keys_.empty()) return;
    if (keys_.size() > 1)
      first_.message += fmt::format(" and {} more that players see", keys_.size() - 1);
    diagnostics_.push_back(std::move(first_));
  }

 private:
  Diagnostics& diagnostics_;
  Diagnostic first_;
  Names keys_;
};

void checkFileName(const std::string& path, Diagnostics& diagnostics) {
  static const std::regex kCode("/lang/[a-z]{2,4}(_[a-z0-9]{2,4})?\\.lang");
  if (std::regex_match(lowerCase(path), kCode)) return;
  diagnostics.push_back({.severity = Severity::Warning,
                         .id = "language-file",
                         .at = {.file = path},
                         .message = "the file is named after no language, so nobody sees its texts",
                         .hint = "names are like en_us.lang, de_de.lang, zh_cn.lang"});
}

/// The key that a word on a screen needs; "" when it needs none.
std::string languageKey(const std::string& word, const ShaderPack& pack) {
  if (word.size() > 2 && word.front() == '[' && word.back() == ']') {
    return "screen." + word.substr(1, word.size() - 2);
  }
  return pack.options.find(word) ? "option." + word : "";
}

}  // namespace

void checkLanguageKeys(std::span<const ShaderPack> folders, Diagnostics& diagnostics) {
  const ShaderPack& pack = folders.front();
  const auto known = optionNames(pack);
  for (const std::string& path : languageFiles(pack)) {
    checkFileName(path, diagnostics);
    FileCheck(pack, known, readLanguageFile(pack, path), diagnostics).run();
  }
}

void checkLanguageCover(std::span<const ShaderPack> folders, Diagnostics& diagnostics) {
  const ShaderPack& pack = folders.front();
  const auto english = pack.languages.find("en_us");
  if (english == pack.languages.end()) return;
  const auto missing = [&](const std::string& key) {
    return !key.empty() && !english->second.contains(key);
  };
  Missing texts(diagnostics);
  const bool profiles = std::ranges::any_of(pack.properties.screens, [](const Screen& screen) {
    return std::ranges::find(screen.entries, "<profile>") != screen.entries.end();
  });
  for (const PropertyEntry& entry : originalProperties(pack)) {
    if (profiles && entry.key.starts_with("profile.") && missing(entry.key))
      texts.add(propertyDiagnostic(Severity::Warning, "language-missing", entry, ""), entry.key);
    if (!isScreenKey(entry.key)) continue;
    for (const PropertyWord& word : locatedWords(entry)) {
      const std::string key = languageKey(word.text, pack);
      if (missing(key))
        texts.add(wordDiagnostic(Severity::Warning, "language-missing", word, ""), key);
    }
  }
  texts.report();
}

}  // namespace orris
