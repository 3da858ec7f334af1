#include "app/window/option_pages.h"

#include <algorithm>
#include <set>

#include "app/commands/option_tree.h"
#include <orris/pack/files/text.h>

namespace orris {
namespace {

// Iris: OptionMenuElementScreen.getColumnCount.
constexpr std::size_t kMostOfTwoColumns = 18;

const Screen* findScreen(const ShaderPack& pack, const std::string& name) {
  const auto& screens = pack.properties.screens;
  const auto found = std::ranges::find(screens, name, &Screen::name);
  return found == screens.end() ? nullptr : &*found;
}

/// "[SUB]" without its brackets, "" for other words.
std::string linkedScreen(const std::string& word) {
  const bool link = word.size() > 2 && word.front() == '[' && word.back() == ']';
  return link ? word.substr(1, word.size() - 2) : "";
}

void setLabel(const ShaderPack& pack, const std::string& key, const std::string& name,
              OptionCell& cell) {
  cell.label = labelOf(pack, key);
  cell.labelMissing = cell.label.empty();
  if (cell.labelMissing) cell.label = name;
  cell.comment = labelOf(pack, key + ".comment");
}

OptionCell optionCell(const ShaderPack& pack, const Option& option) {
  OptionCell cell;
  const auto& sliders = pack.properties.sliders;
  const bool slider = std::ranges::find(sliders, option.name) != sliders.end();
  cell.kind = option.isBoolean ? OptionCell::Kind::Boolean
              : slider         ? OptionCell::Kind::Slider
                               : OptionCell::Kind::Choice;
  cell.name = option.name;
  setLabel(pack, "option." + option.name, option.name, cell);
  if (cell.comment.empty()) cell.comment = option.comment;
  cell.value = pack.options.value(pack.values, option.name);
  cell.valueLabel = valueLabelOf(pack, option, cell.value);
  cell.values = option.values;
  cell.changed = cell.value != option.defaultValue;
  return cell;
}

OptionCell profileCell(const ShaderPack& pack) {
  OptionCell cell{.kind = OptionCell::Kind::Profile, .label = "Profile"};
  cell.value = pack.currentProfile();
  cell.valueLabel = cell.value.empty() ? "Custom" : labelOf(pack, "profile." + cell.value);
  if (cell.valueLabel.empty()) cell.valueLabel = cell.value;
  cell.comment = labelOf(pack, "profile.comment");
  for (const Profile& profile : pack.properties.profiles) cell.values.push_back(profile.name);
  return cell;
}

bool leadsToChange(const ShaderPack& pack, const std::string& screen, std::set<std::string>& seen) {
  const Screen* found = findScreen(pack, screen);
  if (found == nullptr || !seen.insert(screen).second) return false;
  return std::ranges::any_of(found->entries, [&](const std::string& word) {
    const std::string linked = linkedScreen(word);
    return linked.empty() ? pack.values.contains(word) : leadsToChange(pack, linked, seen);
  });
}

OptionCell screenCell(const ShaderPack& pack, const std::string& name) {
  OptionCell cell{.kind = OptionCell::Kind::Screen, .name = name};
  setLabel(pack, "screen." + name, name, cell);
  std::set<std::string> seen;
  cell.changed = leadsToChange(pack, name, seen);
  return cell;
}

/// Options that no screen names.
std::vector<OptionCell> otherCells(const ShaderPack& pack) {
  std::set<std::string> named;
  for (const Screen& screen : pack.properties.screens)
    named.insert(screen.entries.begin(), screen.entries.end());
  std::vector<OptionCell> cells;
  for (const auto& [name, option] : pack.options.all())
    if (!named.contains(name)) cells.push_back(optionCell(pack, option));
  return cells;
}

void addCells(const ShaderPack& pack, const std::string& word, std::vector<OptionCell>& cells) {
  if (word == "*") {
    for (OptionCell& cell : otherCells(pack)) cells.push_back(std::move(cell));
  } else if (word == "<profile>") {
    if (!pack.properties.profiles.empty()) cells.push_back(profileCell(pack));
  } else if (word == "<empty>") {
    cells.emplace_back();
  } else if (const std::string linked = linkedScreen(word); !linked.empty()) {
    cells.push_back(screenCell(pack, linked));
  } else if (const Option* option = pack.options.find(word)) {
    cells.push_back(optionCell(pack, *option));
  } else {
    cells.push_back({.kind = OptionCell::Kind::Missing, .name = word, .label = word});
  }
}

}  // namespace

std::string valueLabelOf(const ShaderPack& pack, const Option& option, const std::string& value) {
  if (option.isBoolean) return value == "true" ? "ON" : "OFF";
  const std::string prefix = labelOf(pack, "prefix." + option.name);
  const std::string named = labelOf(pack, "value." + option.name + "." + value);
  return prefix + (named.empty() ? value + labelOf(pack, "suffix." + option.name) : named);
}

std::string valueBeside(const Option& option, const std::string& value, int steps) {
  const int count = int(option.values.size());
  if (count == 0) return value;
  const auto found = std::ranges::find(option.values, value);
  const int at = found == option.values.end() ? 0 : int(found - option.values.begin());
  return option.values[std::size_t(((at + steps) % count + count) % count)];
}

OptionPage optionPage(const ShaderPack& pack, const std::string& screen) {
  OptionPage page;
  const Screen* found = findScreen(pack, screen);
  if (found == nullptr) found = findScreen(pack, "");
  if (found == nullptr) {
    page.cells = otherCells(pack);
  } else {
    page.name = found->name;
    for (const std::string& word : found->entries) addCells(pack, word, page.cells);
  }
  page.title = page.name.empty() ? pack.name : screenCell(pack, page.name).label;
  page.columns = page.cells.size() > kMostOfTwoColumns ? 3 : 2;
  if (found != nullptr && found->columns) page.columns = std::clamp(*found->columns, 1, 8);
  return page;
}

OptionPage searchOptions(const ShaderPack& pack, const std::string& text) {
  OptionPage page{.title = "Options with \"" + text + "\""};
  const std::vector<std::string> words = splitBlanks(text);
  for (const auto& [name, option] : pack.options.all())
    if (matchesFilter(pack, option, words)) page.cells.push_back(optionCell(pack, option));
  return page;
}

}  // namespace orris
