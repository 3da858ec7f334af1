#include "app/commands/option_tree.h"

#include <fmt/format.h>

#include <algorithm>

#include <orris/pack/files/text.h>

namespace orris {
namespace {

constexpr std::size_t kIndent = 2;

class TreeWriter {
 public:
  TreeWriter(const ShaderPack& pack, const std::function<bool(const Option&)>& wanted,
             const OptionLines& lines)
      : pack_(pack), wanted_(wanted), lines_(lines) {}

  std::string write() {
    std::string text = screen("", 0);
    const bool screens = !pack_.properties.screens.empty();
    std::string rest;
    for (const auto& [name, option] : pack_.options.all()) {
      if (!shown_.contains(name)) rest += entry(name, screens ? kIndent : 0);
    }
    return text + (screens && !rest.empty() ? "on no screen\n" : "") + rest;
  }

 private:
  const Screen* find(const std::string& name) const {
    const auto& screens = pack_.properties.screens;
    const auto found = std::ranges::find(screens, name, &Screen::name);
    return found == screens.end() ? nullptr : &*found;
  }

  std::string screen(const std::string& name, std::size_t depth) {
    const Screen* found = find(name);
    if (!found) return "";
    const std::string title = titleOf(name);
    const std::string head = std::string(depth * kIndent, ' ') + title;
    if (!written_.insert(name).second) return head + " (see above)\n";
    std::string body;
    for (const std::string& word : found->entries) body += entry(word, (depth + 1) * kIndent);
    return body.empty() ? "" : head + '\n' + body;
  }

  std::string titleOf(const std::string& name) const {
    if (name.empty()) return "main screen";
    const std::string label = labelOf(pack_, "screen." + name);
    return fmt::format("[{}]{}", name, label.empty() ? "" : " " + label);
  }

  std::string entry(const std::string& word, std::size_t indent) {
    if (word.size() > 2 && word.front() == '[' && word.back() == ']')
      return screen(word.substr(1, word.size() - 2), indent / kIndent);
    if (word == "*") return others(indent);
    const Option* option = pack_.options.find(word);
    if (!option) return "";
    shown_.insert(word);
    if (!wanted_(*option)) return "";
    std::string text;
    for (const std::string& line : lines_(*option)) {
      text += std::string(indent + (text.empty() ? 0 : kIndent), ' ') + line + '\n';
    }
    return text;
  }

  /// "*" stands for all options that no screen names.
  std::string others(std::size_t indent) {
    std::set<std::string> named;
    for (const Screen& one : pack_.properties.screens)
      named.insert(one.entries.begin(), one.entries.end());
    std::string text;
    for (const auto& [name, option] : pack_.options.all()) {
      if (!named.contains(name)) text += entry(name, indent);
    }
    return text;
  }

  const ShaderPack& pack_;
  const std::function<bool(const Option&)>& wanted_;
  const OptionLines& lines_;
  std::set<std::string> shown_, written_;
};

}  // namespace

std::string labelOf(const ShaderPack& pack, const std::string& key) {
  const auto language = pack.languages.find("en_us");
  if (language == pack.languages.end()) return "";
  const auto label = language->second.find(key);
  return label == language->second.end() ? "" : label->second;
}

bool matchesFilter(const ShaderPack& pack, const Option& option,
                   const std::vector<std::string>& words) {
  std::string text = fmt::format("{} {} {}", option.name,
                                 labelOf(pack, "option." + option.name), option.comment);
  for (const std::string& value : option.values) text += " " + value;
  text = lowerCase(text);
  return std::ranges::all_of(words, [&](const std::string& word) {
    return text.find(lowerCase(word)) != std::string::npos;
  });
}

std::string optionTree(const ShaderPack& pack, const std::function<bool(const Option&)>& wanted,
                       const OptionLines& lines) {
  return TreeWriter(pack, wanted, lines).write();
}

}  // namespace orris
