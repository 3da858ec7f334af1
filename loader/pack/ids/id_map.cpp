#include <orris/pack/ids/id_map.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include <orris/pack/files/properties_text.h>
#include <orris/pack/files/text.h>
#include <orris/pack/ids/block_tags.h>
#include <orris/pack/ids/id_lines.h>

namespace orris {
namespace {

constexpr long long kHighestId = 2147483646;

/// Which lines of a text, from 1, are within C comments. To the host they are as all others, but
/// packs hide ids in comments to include the file in their programs, or write comments this way.
class CommentLines {
 public:
  explicit CommentLines(std::string_view text) {
    bool inside = false;
    for (const std::string& line : splitLines(text)) {
      const size_t open = line.rfind("/*"), close = line.rfind("*/");
      const bool opens = open != line.npos && (close == line.npos || close < open);
      marked_.push_back(open != line.npos || close != line.npos || trim(line).starts_with("//"));
      inside_.push_back(inside);
      inside = opens || (inside && close == line.npos);
    }
  }
  bool hasMark(int line) const { return at(marked_, line); }
  bool isInside(int line) const { return at(inside_, line); }

 private:
  static bool at(const std::vector<bool>& flags, int line) {
    return line > 0 && static_cast<size_t>(line) <= flags.size() &&
           flags[static_cast<size_t>(line) - 1];
  }
  std::vector<bool> marked_, inside_;
};

/// Reports lines without a key that were meant to continue another, where ids are listed.
void reportStrayLines(const std::vector<PropertyEntry>& known,
                      const std::vector<PropertyEntry>& others, std::string_view text,
                      std::string_view prefix, Diagnostics& diagnostics) {
  const CommentLines comments(text);
  std::array<bool, 2> hasIds{};  // outside and inside comments
  for (const PropertyEntry& id : known) hasIds[comments.isInside(id.at.line)] = true;
  for (const PropertyEntry& entry : others) {
    const int line = entry.at.line;
    if (entry.lines.front().find('=') != std::string::npos || comments.hasMark(line)) continue;
    if (!hasIds[comments.isInside(line)]) continue;
    diagnostics.push_back(propertyDiagnostic(
        Severity::Warning, "id-stray-line", entry, "this line belongs to no key and is ignored",
        fmt::format("end the line before it with a backslash, or start it with {}", prefix)));
  }
}

/// Entries of a file in order of their keys.
std::vector<PropertyEntry> idEntries(const std::string& file, const std::string& text,
                                     const std::string& original,
                                     const std::vector<std::string_view>& prefixes,
                                     Diagnostics& diagnostics) {
  auto entries = lastValues(parseIdLines(file, text, original, &diagnostics));
  const auto others =
      std::stable_partition(entries.begin(), entries.end(), [&](const PropertyEntry& entry) {
        return std::any_of(prefixes.begin(), prefixes.end(),
                           [&](auto& prefix) { return entry.key.starts_with(prefix); });
      });
  const std::vector<PropertyEntry> stray(others, entries.end());
  entries.erase(others, entries.end());
  reportStrayLines(entries, stray, original, prefixes.front(), diagnostics);
  return entries;
}

/// The number after the prefix; nullopt and a warning when it is none.
std::optional<int> parseId(const PropertyEntry& entry, size_t prefix, Diagnostics& diagnostics) {
  const auto id = parseInteger(std::string_view(entry.key).substr(prefix));
  if (id && *id >= 0 && *id <= kHighestId) return static_cast<int>(*id);
  diagnostics.push_back(propertyDiagnostic(
      Severity::Warning, "id-number", entry,
      fmt::format("{} has no id; the line is ignored", entry.key), "ids are whole numbers from 0"));
  return std::nullopt;
}

bool matches(const BlockFilter& filter, const std::string& name,
             const std::map<std::string, std::string>& properties) {
  if (filter.isTag ? !hasBlockTag(name, filter.name) : filter.name != name) return false;
  return std::all_of(filter.properties.begin(), filter.properties.end(), [&](const auto& wanted) {
    const auto found = properties.find(wanted.first);
    return found != properties.end() && std::find(wanted.second.begin(), wanted.second.end(),
                                                  found->second) != wanted.second.end();
  });
}

void addLayer(const PropertyEntry& entry, std::string_view layer, BlockIdMap& map,
              Diagnostics& diagnostics) {
  static const std::vector<std::string> kLayers{"solid", "cutout", "cutout_mipped", "translucent"};
  if (std::find(kLayers.begin(), kLayers.end(), layer) == kLayers.end()) {
    diagnostics.push_back(propertyDiagnostic(Severity::Warning, "id-layer", entry,
                                             fmt::format("there is no render layer {}", layer),
                                             "layers are " + joinNames(kLayers)));
    return;
  }
  for (const std::string& block : splitBlanks(entry.value)) {
    map.renderLayers[withNamespace(block)] =
        layer == "cutout_mipped" ? "cutout" : std::string(layer);
  }
}

std::string badPartHint(std::string_view part, std::string_view word) {
  if (word.find("::") != std::string_view::npos) return "write one colon after the namespace";
  if (parseInteger(part))
    return "numbers of states are of the game before 1.13: Iris leaves this one out, so that all "
           "states match";
  return "";
}

/// Words like "stone:6": lists of the game before 1.13 are full of them, so that all of a file are one finding.
struct NumberedStates {
  std::optional<Diagnostic> first;
  std::size_t more = 0;

  void report(Diagnostics& diagnostics) {
    if (!first) return;
    if (more > 0) first->message += fmt::format("; {} more words of this file give numbers", more);
    diagnostics.push_back(std::move(*first));
  }
};

/// The filters of one entry, with a warning for what is no state.
void addFilters(const PropertyEntry& entry, int id, BlockIdMap& map, NumberedStates& numbered,
                Diagnostics& diagnostics) {
  for (const PropertyWord& word : locatedWords(entry)) {
    std::vector<std::string> badParts;
    map.filters.push_back(parseBlockFilter(word.text, id, badParts));
    keepLastProperties(map.filters.back());
    if (badParts.empty()) continue;
    const std::string more =
        badParts.size() == 1 ? " is" : fmt::format(" and {} more are", badParts.size() - 1);
    const bool number = parseInteger(badParts.front()).has_value();
    if (number && numbered.first) {
      ++numbered.more;
      continue;
    }
    Diagnostic bad = wordDiagnostic(
        Severity::Warning, "id-state", word,
        fmt::format("\"{}\" in {}{} no property=value", badParts.front(), word.text, more),
        badPartHint(badParts.front(), word.text));
    number ? void(numbered.first = std::move(bad)) : diagnostics.push_back(std::move(bad));
  }
}

}  // namespace

// Iris: BlockEntry, TagEntry.
BlockFilter parseBlockFilter(std::string_view word, int id, std::vector<std::string>& badParts) {
  BlockFilter filter{.isTag = word.starts_with('%'), .id = id};
  if (filter.isTag) word.remove_prefix(1);
  const auto parts = splitAt(word, ':');
  const bool hasNamespace = parts.size() > 1 && parts[1].find('=') == std::string_view::npos;
  filter.name = withNamespace(parts[0]);
  if (hasNamespace) filter.name = std::string(parts[0]) + ":" + std::string(parts[1]);
  for (size_t i = hasNamespace ? 2 : 1; i < parts.size(); ++i) {
    const size_t equals = parts[i].find('=');
    if (equals == std::string_view::npos) {
      badParts.emplace_back(parts[i]);
      continue;
    }
    std::vector<std::string> values;
    for (const auto value : splitAt(parts[i].substr(equals + 1), ',')) values.emplace_back(value);
    filter.properties.emplace_back(parts[i].substr(0, equals), std::move(values));
  }
  return filter;
}

// Iris: BlockEntry.parse, a map by name.
void keepLastProperties(BlockFilter& filter) {
  decltype(filter.properties) kept;
  for (auto& property : filter.properties) {
    std::erase_if(kept, [&](const auto& before) { return before.first == property.first; });
    kept.push_back(std::move(property));
  }
  filter.properties = std::move(kept);
}

int BlockIdMap::idOf(const std::string& name,
                     const std::map<std::string, std::string>& properties) const {
  // A block that is named always wins over its tags.
  for (const bool tags : {false, true}) {
    for (const BlockFilter& filter : filters) {
      if (filter.isTag == tags && matches(filter, name, properties)) return filter.id;
    }
  }
  return -1;
}

BlockIdMap parseBlockProperties(const std::string& file, const std::string& text,
                                const std::string& original, Diagnostics& diagnostics) {
  constexpr std::string_view kBlock = "block.", kLayer = "layer.";
  BlockIdMap map;
  map.present = true;
  NumberedStates numbered;
  for (const PropertyEntry& entry :
       idEntries(file, text, original, {kBlock, kLayer}, diagnostics)) {
    if (entry.key.starts_with(kLayer)) {
      addLayer(entry, std::string_view(entry.key).substr(kLayer.size()), map, diagnostics);
    } else if (const auto id = parseId(entry, kBlock.size(), diagnostics)) {
      addFilters(entry, *id, map, numbered, diagnostics);
    }
  }
  numbered.report(diagnostics);
  return map;
}

std::map<std::string, int> parseIdProperties(const std::string& file, const std::string& text,
                                             const std::string& original, const std::string& prefix,
                                             Diagnostics& diagnostics) {
  std::map<std::string, int> ids;
  for (const PropertyEntry& entry : idEntries(file, text, original, {prefix}, diagnostics)) {
    const auto id = parseId(entry, prefix.size(), diagnostics);
    if (!id) continue;
    for (const std::string& word : splitBlanks(entry.value)) {
      if (word.find('=') == std::string::npos) ids[withNamespace(word)] = *id;
    }
  }
  return ids;
}

}  // namespace orris
