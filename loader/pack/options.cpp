#include "pack/options.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "pack/option_line.h"
#include "pack/text.h"

namespace orris {
namespace {

SourceLocation place(const std::string& file, size_t index, const std::string& line) {
  const size_t column = line.find_first_not_of(" \t");
  return {file, static_cast<int>(index) + 1,
          static_cast<int>(column == std::string::npos ? 0 : column) + 1};
}

std::set<std::string, std::less<>> findReferences(const std::map<std::string, FileLines>& files) {
  std::set<std::string, std::less<>> references;
  for (const auto& [file, lines] : files) {
    for (const std::string& line : lines) {
      if (line.find("#if") == std::string::npos) continue;
      const std::string_view name = booleanReference(line);
      if (!name.empty()) references.emplace(name);
    }
  }
  return references;
}

/// Merges one definition into the option of its name.
class Merger {
 public:
  Merger(std::map<std::string, Option, std::less<>>& options, Diagnostics& diagnostics)
      : options_(options), diagnostics_(diagnostics) {}

  void add(OptionLine line, SourceLocation at, const std::string& text) {
    const auto [found, isNew] = options_.try_emplace(line.name);
    Option& option = found->second;
    if (isNew) {
      option = {line.name, line.isBoolean, line.value, std::move(line.values), line.comment, {at}};
      return;
    }
    if (option.isBoolean != line.isBoolean || option.defaultValue != line.value) {
      if (dropped_.insert(line.name).second) report(option, line, at, text);
      return;
    }
    if (option.comment.empty()) option.comment = line.comment;
    option.at.push_back(std::move(at));
  }

  /// Takes the ambiguous options out; gives their names and first lines.
  std::map<std::string, SourceLocation> dropAmbiguous() {
    std::map<std::string, SourceLocation> places;
    for (const std::string& name : dropped_) {
      places.emplace(name, options_.at(name).at.front());
      options_.erase(name);
    }
    return places;
  }

 private:
  void report(const Option& option, const OptionLine& line, const SourceLocation& at,
              const std::string& text) {
    const SourceLocation& first = option.at.front();
    diagnostics_.push_back(
        {.severity = Severity::Note,
         .id = "option-ambiguous",
         .at = at,
         .message = fmt::format("{} is {} here and {} in {}:{}, so it is no option", line.name,
                                line.value, option.defaultValue, first.file, first.line),
         .sourceLine = text,
         .hint = "give all its lines the same default"});
  }

  std::map<std::string, Option, std::less<>>& options_;
  Diagnostics& diagnostics_;
  std::set<std::string> dropped_;
};

void reject(OptionSet& options, std::string_view name, SourceLocation at, bool isBoolean) {
  const auto [found, isNew] = options.rejected().try_emplace(std::string(name));
  if (!isNew) return;
  found->second = {std::move(at), isBoolean
                                      ? fmt::format("no line is #ifdef {0} or #ifndef {0}", name)
                                      : "no list of values like // [1 2 3] follows"};
}

}  // namespace

const Option* OptionSet::find(std::string_view name) const {
  const auto found = options_.find(name);
  return found == options_.end() ? nullptr : &found->second;
}

std::string OptionSet::value(const OptionValues& values, std::string_view name) const {
  const auto chosen = values.find(std::string(name));
  if (chosen != values.end()) return chosen->second;
  const Option* option = find(name);
  return option ? option->defaultValue : "";
}

const RejectedOption* OptionSet::rejected(std::string_view name) const {
  const auto found = rejected_.find(name);
  return found == rejected_.end() ? nullptr : &found->second;
}

std::string missingOptionHint(const OptionSet& options, std::string_view name) {
  if (const RejectedOption* rejected = options.rejected(name)) {
    return fmt::format("{}:{} defines it, but {}", rejected->at.file, rejected->at.line,
                       rejected->reason);
  }
  std::vector<std::string> names;
  for (const auto& entry : options.all()) names.push_back(entry.first);
  return suggest(name, names);
}

OptionSet discoverOptions(const std::map<std::string, FileLines>& files, Diagnostics& diagnostics) {
  const auto references = findReferences(files);
  OptionSet options;
  Merger merger(options.all(), diagnostics);
  for (const auto& [file, lines] : files) {
    for (size_t i = 0; i < lines.size(); ++i) {
      auto option = parseOptionLine(lines[i]);
      if (option && (!option->isBoolean || references.contains(option->name))) {
        merger.add(std::move(*option), place(file, i, lines[i]), lines[i]);
      } else if (const std::string_view name = definedName(lines[i]); !name.empty()) {
        reject(options, name, place(file, i, lines[i]), option.has_value());
      }
    }
  }
  for (const auto& [name, at] : merger.dropAmbiguous()) {
    options.rejected()[name] = {at, "its lines have different defaults"};
  }
  return options;
}

std::map<std::string, FileLines> editedFiles(const std::map<std::string, FileLines>& files,
                                             const OptionSet& options, const OptionValues& values) {
  std::map<std::string, FileLines> edited;
  for (const auto& [name, value] : values) {
    const Option* option = options.find(name);
    if (!option || value == option->defaultValue) continue;
    for (const SourceLocation& at : option->at) {
      auto file = edited.find(at.file);
      if (file == edited.end()) file = edited.emplace(at.file, files.at(at.file)).first;
      std::string& line = file->second.at(static_cast<size_t>(at.line) - 1);
      if (const auto parsed = parseOptionLine(line)) line = editOptionLine(line, *parsed, value);
    }
  }
  return edited;
}

std::map<std::string, FileLines> applyOptions(const std::map<std::string, FileLines>& files,
                                              const OptionSet& options,
                                              const OptionValues& values) {
  std::map<std::string, FileLines> result = editedFiles(files, options, values);
  result.insert(files.begin(), files.end());
  return result;
}

}  // namespace orris
