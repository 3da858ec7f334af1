#include <orris/check/ids/id_checks.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include <orris/check/ids/block_names.h>
#include <orris/check/ids/block_states.h>
#include <orris/check/ids/lost_blocks.h>
#include <orris/check/pack/pack_texts.h>
#include <orris/core/limits.h>
#include <orris/core/files/text_file.h>
#include <orris/pack/files/text.h>
#include <orris/pack/ids/id_lines.h>
#include <orris/pack/ids/id_map.h>

namespace orris {
namespace {

/// The entries of one file in active lines.
struct IdFile {
  std::vector<PropertyEntry> entries;
  Branches branches;
};

IdFile readIdFile(const ShaderPack& pack, const std::string& file, std::string_view prefix) {
  const std::string text = readText(*pack.source, file).value_or("");
  Diagnostics reported;
  const std::string active = preprocessProperties(file, text, pack.propertyMacros, reported);
  IdFile read{parseIdLines(file, active, text, nullptr), Branches(text)};
  std::erase_if(read.entries, [&](auto& entry) { return !entry.key.starts_with(prefix); });
  return read;
}

void checkKeysTwice(const IdFile& file, Diagnostics& diagnostics) {
  std::map<std::string_view, const PropertyEntry*> last;
  for (const PropertyEntry& entry : file.entries) {
    const auto [before, isNew] = last.try_emplace(entry.key, &entry);
    if (isNew) continue;
    const PropertyEntry& first = *before->second;
    before->second = &entry;
    // A default before the #if that changes it is no slip.
    if (!file.branches.implies(first.at.line, entry.at.line)) continue;
    const bool same = splitBlanks(first.value) == splitBlanks(entry.value);
    diagnostics.push_back(propertyDiagnostic(
        same ? Severity::Note : Severity::Warning, "id-key-twice", entry,
        fmt::format("{} is given again, so what line {} lists is lost", entry.key, first.at.line),
        same ? "" : "the last line of a key counts: put the names on one, or use another number"));
  }
}

/// Does every state that `filter` accepts match `earlier` too?
bool covers(const BlockFilter& earlier, const BlockFilter& filter) {
  return std::all_of(earlier.properties.begin(), earlier.properties.end(), [&](const auto& wanted) {
    const auto same = std::find_if(filter.properties.begin(), filter.properties.end(),
                                   [&](const auto& p) { return p.first == wanted.first; });
    if (same == filter.properties.end()) return false;
    return std::all_of(same->second.begin(), same->second.end(), [&](const std::string& value) {
      return std::find(wanted.second.begin(), wanted.second.end(), value) != wanted.second.end();
    });
  });
}

/// Filters that never match because an earlier one takes all their states.
class BlockCheck {
 public:
  BlockCheck(const Branches& branches, Diagnostics& diagnostics)
      : branches_(branches), diagnostics_(diagnostics) {}

  void add(const PropertyEntry& entry) {
    for (const PropertyWord& word : locatedWords(entry)) {
      // Words of a line that its author took for a comment, swallowed by the line before; and a word
      // that lost its last letter, which is reported as that.
      if (trim(word.sourceLine).starts_with("//") || isCut(word, entry)) continue;
      if (word.text.starts_with(':')) {
        reportBlank(word);
        continue;
      }
      std::vector<std::string> numbers;
      BlockFilter filter = parseBlockFilter(word.text, 0, numbers);
      checkStates(filter, word);
      keepLastProperties(filter);
      // None says what its author meant: they are reported as what they are.
      if (isMisspelt(filter, word, entry)) continue;
      if (!filter.isTag && !isIdentifier(filter.name)) noIdentifiers_.push_back(word);
      if (!numbers.empty()) continue;
      ListedBlock listed{&entry, word.text, word.at, !filter.properties.empty()};
      auto& before = seen_[{filter.isTag, filter.name}];
      // Where the first may be missing, this one is what counts then.
      const auto first = std::find_if(before.begin(), before.end(), [&](const Before& b) {
        return covers(b.filter, filter) && branches_.implies(word.at.line, b.listed.at.line);
      });
      if (first != before.end()) {
        if (!isLegacy(filter)) lost_.push_back({first->listed, std::move(listed)});
      } else if (before.size() < kMostFilters) {
        before.push_back({std::move(filter), std::move(listed)});
      }
    }
  }

  const std::vector<LostBlock>& lost() const { return lost_; }

  /// Iris: BlockMaterialMapping.addBlockStates, which lets the exception of the game through.
  void reportNoIdentifiers() {
    if (noIdentifiers_.empty()) return;
    const PropertyWord& first = noIdentifiers_.front();
    const std::string more =
        noIdentifiers_.size() == 1
            ? ""
            : fmt::format(", nor can others of this file ({})", noIdentifiers_.size() - 1);
    diagnostics_.push_back(wordDiagnostic(
        Severity::Warning, "id-block", first,
        fmt::format("{} can be no name of a block{}: the game refuses it, and Iris ends with \"Failed "
                    "to get entry\"",
                    filterName(first.text), more),
        "names have small letters, digits and _ - . / only; lists of older games stand behind "
        "#if MC_VERSION < 11300"));
  }

 private:
  struct Before {
    BlockFilter filter;
    ListedBlock listed;
  };
  // A block has some hundred states; beyond that the search would grow with the square.
  static constexpr size_t kMostFilters = 1024;

  /// States of versions before 1.13 match nothing since, and their rules were OptiFine's.
  static bool isLegacy(const BlockFilter& filter) {
    return std::any_of(filter.properties.begin(), filter.properties.end(), [](const auto& wanted) {
      const StateProperty* property = findStateProperty(wanted.first);
      return property && property->values.empty();
    });
  }

  static bool lists(const PropertyEntry& entry, std::string_view block) {
    return std::ranges::any_of(splitBlanks(entry.value), [&](std::string_view word) {
      if (word.starts_with("minecraft:")) word.remove_prefix(10);
      return word.substr(0, word.find(':')) == block;
    });
  }

  /// Has Iris taken its last letter away?
  static bool isCut(const PropertyWord& word, const PropertyEntry& entry) {
    return !word.written && std::ranges::any_of(entry.lines, [&](const std::string& line) {
      return std::ranges::any_of(splitBlanks(line), [&](std::string whole) {
        whole.pop_back();
        return whole == word.text || whole.ends_with("=" + word.text);
      });
    });
  }

  /// Of the game: small letters, digits and _ - . in the namespace, / too in the name.
  static bool isIdentifier(std::string_view name) {
    return name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_-./:") == name.npos;
  }

  static std::string filterName(const std::string& word) {
    std::vector<std::string> ignored;
    return parseBlockFilter(word, 0, ignored).name;
  }

  /// "birch_slab :type=top".
  void reportBlank(const PropertyWord& word) {
    diagnostics_.push_back(wordDiagnostic(
        Severity::Warning, "id-block", word,
        fmt::format("{} belongs to no block, for a blank stands before it", word.text),
        "take the blank away"));
  }

  /// Not where the line has the other name too: that of another version of the game.
  bool isMisspelt(const BlockFilter& filter, const PropertyWord& word, const PropertyEntry& entry) {
    constexpr std::string_view kGame = "minecraft:";
    if (filter.isTag || !filter.name.starts_with(kGame)) return false;
    const std::string meant = meantBlock(std::string_view(filter.name).substr(kGame.size()));
    if (meant.empty() || lists(entry, meant)) return false;
    diagnostics_.push_back(wordDiagnostic(Severity::Warning, "id-block", word,
                                          fmt::format("the game has no block {}", filter.name),
                                          fmt::format("did you mean {}?", meant)));
    return true;
  }

  void checkStates(const BlockFilter& filter, const PropertyWord& word) {
    if (!filter.name.starts_with("minecraft:")) return;
    for (const auto& [name, values] : filter.properties) {
      const StateProperty* property = findStateProperty(name);
      if (!property) {
        checkName(name, word);
        continue;
      }
      for (const std::string& value : values) checkValue(*property, value, word);
    }
  }

  void checkName(const std::string& name, const PropertyWord& word) {
    constexpr size_t kShortest = 4;
    static const std::vector<std::string> kNames = [] {
      std::vector<std::string> names;
      for (const StateProperty& property : stateProperties()) names.emplace_back(property.name);
      return names;
    }();
    const auto [known, isNew] = meant_.try_emplace(name);
    if (isNew && name.size() >= kShortest && meant_.size() <= limits::kSuggestions)
      known->second = likelyMeant(name, kNames);
    const std::string& meant = known->second;
    if (meant.empty()) return;
    diagnostics_.push_back(
        wordDiagnostic(Severity::Warning, "id-property", word,
                       fmt::format("\"{}\" in {} is no property of a block", name, word.text),
                       fmt::format("did you mean {}?", meant)));
  }

  void checkValue(const StateProperty& property, const std::string& value,
                  const PropertyWord& word) {
    const auto& known = property.values;
    if (known.empty() || std::find(known.begin(), known.end(), value) != known.end()) return;
    const std::string meant =
        hints_++ < limits::kSuggestions ? likelyMeant(value, known) : std::string();
    if (meant.empty() && !property.closed) return;
    diagnostics_.push_back(wordDiagnostic(
        Severity::Warning, "id-property", word,
        fmt::format("\"{}\" in {} is no value of {}", value, word.text, property.name),
        !meant.empty()              ? fmt::format("did you mean {}?", meant)
        : !gluedTo(value, known).empty()
            ? fmt::format("a blank seems to be missing after {}", gluedTo(value, known))
            : "its values are " + joinNames(known)));
  }

  /// The value that stands before a block's name in "falsespruce_door"; "" for none.
  static std::string gluedTo(std::string_view value, const std::vector<std::string>& known) {
    constexpr size_t kShortestBlock = 3;
    std::string longest;
    for (const std::string& start : known) {
      if (value.starts_with(start) && value.size() >= start.size() + kShortestBlock &&
          start.size() > longest.size() && value.find('_') != std::string_view::npos)
        longest = start;
    }
    return longest;
  }

  const Branches& branches_;
  Diagnostics& diagnostics_;
  std::size_t hints_ = 0;
  std::map<std::pair<bool, std::string>, std::vector<Before>> seen_;
  std::vector<LostBlock> lost_;
  std::map<std::string, std::string> meant_;  ///< of names that are no property
  std::vector<PropertyWord> noIdentifiers_;
};

void checkBlocks(const IdFile& file, Diagnostics& diagnostics) {
  const std::vector<PropertyEntry> entries = lastValues(file.entries);
  BlockCheck check(file.branches, diagnostics);
  for (const PropertyEntry& entry : entries) check.add(entry);
  check.reportNoIdentifiers();
  reportLostBlocks(check.lost(), diagnostics);
}

/// Iris: IdMap.parseIdMap, parseDimensionMap: of two lines with the same name the later one counts,
/// so that a line for many may stand before lines for some of them.
void checkIdNames(const IdFile& file, Diagnostics& diagnostics) {
  std::map<std::string, std::pair<std::string, int>> seen;
  for (const PropertyEntry& entry : lastValues(file.entries)) {
    for (const PropertyWord& word : locatedWords(entry)) {
      const bool plain = word.text.find(':') == std::string::npos && word.text != "*";
      const std::string name = (plain ? "minecraft:" : "") + word.text;
      const auto [first, isNew] = seen.try_emplace(name, entry.key, word.at.line);
      if (isNew) continue;
      diagnostics.push_back(
          wordDiagnostic(Severity::Note, "id-repeated", word,
                         fmt::format("{} has {} already, from line {}; the last line counts",
                                     word.text, first->second.first, first->second.second)));
    }
  }
}

}  // namespace

void checkIdMaps(std::span<const ShaderPack> folders, Diagnostics& diagnostics) {
  struct Map {
    const char* file;
    std::string_view prefix;
    void (*check)(const IdFile&, Diagnostics&);
  };
  constexpr std::array<Map, 4> kMaps{{{"/block.properties", "block.", checkBlocks},
                                      {"/item.properties", "item.", checkIdNames},
                                      {"/entity.properties", "entity.", checkIdNames},
                                      {"/dimension.properties", "dimension.", checkIdNames}}};
  for (const Map& map : kMaps) {
    const IdFile file = readIdFile(folders.front(), map.file, map.prefix);
    checkKeysTwice(file, diagnostics);
    map.check(file, diagnostics);
  }
}

}  // namespace orris
