#include <orris/check/ids/lost_blocks.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include <orris/pack/files/text.h>

namespace orris {
namespace {

using Group = std::vector<const LostBlock*>;
using Place = std::pair<int, int>;

Place blockPlace(const SourceLocation& at) { return {at.line, at.column}; }

void add(Severity severity, const char* id, const ListedBlock& at, std::string message,
         std::vector<std::string> notes, std::string hint, Diagnostics& diagnostics) {
  const auto line = static_cast<size_t>(at.at.line - at.entry->at.line);
  Diagnostic& diagnostic = diagnostics.emplace_back(wordDiagnostic(
      severity, id, {at.text, at.at, at.entry->lines[line]}, std::move(message), std::move(hint)));
  diagnostic.notes = std::move(notes);
}

std::string lineList(const Group& group) {
  constexpr size_t kMost = 12;
  std::set<int> lines;
  for (const LostBlock* lost : group) lines.insert(lost->word.at.line);
  std::vector<std::string> listed;
  for (const int line : lines) {
    if (listed.size() < kMost) listed.push_back(std::to_string(line));
  }
  const std::string more =
      lines.size() > kMost ? fmt::format(" and {} more", lines.size() - kMost) : "";
  return (lines.size() == 1 ? "in line " : "in lines ") + joinNames(listed) + more;
}

/// One entry before many that it leaves nothing for.
void reportGreedy(const Group& group, Diagnostics& diagnostics) {
  const ListedBlock& first = group.front()->first;
  const bool forAll = !first.states && std::any_of(group.begin(), group.end(),
                                                   [](auto lost) { return lost->word.states; });
  add(Severity::Warning, "id-twice", first,
      fmt::format("{} has {} here{}, so {} later entries of it do nothing", first.text,
                  first.entry->key, forAll ? " in all its states" : "", group.size()),
      {lineList(group)},
      forAll ? "the first line that fits a block counts: name the states that are meant here, or "
               "put this line last"
             : "the first line that fits a block counts",
      diagnostics);
}

std::string names(const Group& group) {
  constexpr size_t kMost = 3;
  std::vector<std::string> listed;
  for (const LostBlock* lost : group) {
    if (listed.size() < kMost) listed.push_back(lost->word.text);
  }
  const std::string more =
      group.size() > kMost ? fmt::format(" and {} more", group.size() - kMost) : "";
  return joinNames(listed) + more;
}

/// Entries of one line that another line has already.
void reportLine(const Group& group, Diagnostics& diagnostics) {
  const ListedBlock &first = group.front()->first, &word = group.front()->word;
  const bool one = group.size() == 1;
  if (first.entry->key == word.entry->key) {
    const std::string what = one ? "is covered by " + first.text : "are covered by others";
    add(Severity::Note, "id-repeated", word,
        fmt::format("{} {} in line {}, of the same {}", names(group), what, first.at.line,
                    first.entry->key),
        {}, "", diagnostics);
    return;
  }
  const std::string what = !one || first.text == word.text ? "" : fmt::format("as {} ", first.text);
  add(Severity::Warning, "id-twice", word,
      fmt::format("{} {} {} {}already, from line {}", names(group), one ? "has" : "have",
                  first.entry->key, what, first.at.line),
      {},
      one ? "the first line that fits a block counts, so this one does nothing"
          : "the first line that fits a block counts, so these do nothing",
      diagnostics);
}

bool isGreedy(const Group& group) {
  constexpr size_t kFewest = 3;
  return group.size() >= kFewest &&
         std::any_of(group.begin(), group.end(), [&](const LostBlock* lost) {
           return lost->word.at.line != group.front()->word.at.line;
         });
}

}  // namespace

void reportLostBlocks(const std::vector<LostBlock>& lost, Diagnostics& diagnostics) {
  std::map<Place, Group> byFirst;
  std::map<std::pair<int, int>, Group> byLines;
  for (const LostBlock& one : lost) {
    if (one.first.entry->key != one.word.entry->key)
      byFirst[blockPlace(one.first.at)].push_back(&one);
  }
  std::erase_if(byFirst, [](const auto& group) { return !isGreedy(group.second); });
  for (const auto& [place, group] : byFirst) reportGreedy(group, diagnostics);
  for (const LostBlock& one : lost) {
    const bool listed =
        one.first.entry->key != one.word.entry->key && byFirst.contains(blockPlace(one.first.at));
    if (!listed) byLines[{one.word.at.line, one.first.at.line}].push_back(&one);
  }
  for (const auto& [lines, group] : byLines) reportLine(group, diagnostics);
}

}  // namespace orris
