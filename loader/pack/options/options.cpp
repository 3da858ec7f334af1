#include <orris/pack/options/options.h>

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

#include <orris/core/limits.h>
#include <orris/core/message_limits.h>
#include <orris/pack/files/java_order.h>
#include <orris/pack/files/text.h>
#include <orris/pack/options/option_line.h>

namespace orris {
namespace {

SourceLocation place(const std::string& file, size_t index, const std::string& line) {
  const size_t column = line.find_first_not_of(" \t");
  return {file, static_cast<int>(index) + 1,
          static_cast<int>(column == std::string::npos ? 0 : column) + 1};
}

/// The names that lines ask for by #ifdef or #ifndef.
struct References {
  std::set<std::string, std::less<>> names;
  /// Where Iris overlooks it, since text stands behind the name.
  std::map<std::string, SourceLocation, std::less<>> overlooked;
};

References findReferences(const std::map<std::string, FileLines>& files) {
  References references;
  for (const auto& [file, lines] : files) {
    for (size_t i = 0; i < lines.size(); ++i) {
      if (lines[i].find("#if") == std::string::npos) continue;
      const std::string_view name = booleanReference(lines[i]), asked = askedName(lines[i]);
      if (!name.empty())
        references.names.emplace(name);
      else if (!asked.empty())
        references.overlooked.try_emplace(std::string(asked), place(file, i, lines[i]));
    }
  }
  return references;
}

using Options = std::map<std::string, Option, std::less<>>;

/// Merges definitions by name, those of one file first, as Iris does: two that disagree take each
/// other away, and a later one is the first again. Iris: OptionSet.Builder.
class Merger {
 public:
  Merger(Options& options, Diagnostics& diagnostics)
      : options_(options), diagnostics_(diagnostics) {}

  /// `text`: the line of `at`.
  void add(const OptionLine& line, const SourceLocation& at, const std::string& text) {
    const auto [first, isNew] = first_.try_emplace(line.name, Seen{line, at});
    places_[line.name].push_back(at);
    const OptionLine& before = first->second.line;
    const bool differs = before.isBoolean != line.isBoolean || before.value != line.value;
    if (!isNew && differs) differing_.try_emplace(line.name, Seen{line, at, text});
    merge(ofFile_, {line.name, line.isBoolean, line.value, line.values, line.comment, {at}});
  }

  void endFile() {
    for (auto& [name, option] : ofFile_) merge(options_, std::move(option));
    ofFile_.clear();
  }

  /// Reports options whose lines disagree; those that are none go to `rejected`. Options that are
  /// edited stand on all their lines.
  void finish(std::map<std::string, RejectedOption, std::less<>>& rejected) {
    for (const auto& [name, other] : differing_) {
      const auto option = options_.find(name);
      report(other, option == options_.end() ? nullptr : &option->second);
      if (option == options_.end())
        rejected[name] = {first_.at(name).at, "its lines have different defaults"};
    }
    for (auto& [name, option] : options_) {
      option.at = places_.at(name);
      std::ranges::sort(option.at, {}, [](const auto& at) { return std::tie(at.file, at.line); });
    }
  }

 private:
  struct Seen {
    OptionLine line;
    SourceLocation at;
    std::string text{};
  };

  static void merge(Options& into, Option option) {
    const auto [found, isNew] = into.try_emplace(option.name, option);
    if (isNew) return;
    Option& before = found->second;
    if (before.isBoolean != option.isBoolean || before.defaultValue != option.defaultValue) {
      into.erase(found);
    } else if (before.comment.empty()) {
      before = std::move(option);
    }
  }

  void report(const Seen& other, const Option* kept) {
    const Seen& first = first_.at(other.line.name);
    const std::string both =
        fmt::format("{} is {} here and {} in {}:{}", other.line.name, other.line.value,
                    first.line.value, first.at.file, first.at.line);
    const std::string takenBack =
        kept ? fmt::format(
                   ", so Iris drops it where two differ and takes {} back at a later line",
                   kept->defaultValue)
             : ", so it is no option";
    diagnostics_.push_back({.severity = kept ? Severity::Warning : Severity::Note,
                            .id = "option-ambiguous",
                            .at = other.at,
                            .message = both + takenBack,
                            .sourceLine = quotedLine(other.text, 0),
                            .hint = "give all its lines the same default"});
  }

  Options& options_;
  Diagnostics& diagnostics_;
  Options ofFile_;
  std::map<std::string, Seen> first_, differing_;
  std::map<std::string, std::vector<SourceLocation>, std::less<>> places_;
};

/// How many options a pack may have, and how many values one of them.
class OptionLimit {
 public:
  explicit OptionLimit(Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

  /// False, and an error for the first, when the option is beyond the limits.
  bool fits(const OptionLine& line, SourceLocation at) {
    const bool many = line.values.size() > limits::kOptionValues;
    if (!many && names_.size() < limits::kOptions) names_.insert(line.name);
    if (!many && names_.contains(line.name)) return true;
    if (!std::exchange(reported_, true)) {
      diagnostics_.push_back(
          {.severity = Severity::Error,
           .id = "property-limit",
           .at = std::move(at),
           .message = many ? fmt::format("{} has more than {} values; it is no option", line.name,
                                         limits::kOptionValues)
                           : fmt::format("the pack has more than {} options; {} and those after it "
                                         "are none",
                                         limits::kOptions, line.name)});
    }
    return false;
  }

 private:
  Diagnostics& diagnostics_;
  std::set<std::string, std::less<>> names_;
  bool reported_ = false;
};

/// Why a line that defines `name` makes no option. Iris: OptionAnnotatedSource
std::string reasonAgainst(std::string_view line, std::string_view name, bool isBoolean,
                          const References& references) {
  const auto overlooked = references.overlooked.find(name);
  if (isBoolean && overlooked != references.overlooked.end()) {
    return fmt::format("Iris overlooks {}:{}, for the text behind the name: put it on a line of its own",
                       overlooked->second.file, overlooked->second.line);
  }
  if (isBoolean) return fmt::format("no line that a program reads is #ifdef {0} or #ifndef {0}", name);
  const size_t comment = line.find("//", line.find("#define"));
  const size_t open = line.find('[', comment);
  const bool listed = comment != line.npos && open != line.npos && line.find(']', open) != line.npos;
  if (!listed) return "no list of values like // [1 2 3] follows";
  return trim(line).starts_with("//")
             ? "that line is a comment"
             : "Iris takes a word or a number for its value, 2.0 and not 2. or (2.0)";
}

void reject(OptionSet& options, std::string_view name, SourceLocation at, std::string reason) {
  const auto [found, isNew] = options.rejected().try_emplace(std::string(name));
  if (isNew) found->second = {std::move(at), std::move(reason)};
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
  // Of hundreds of options one is always a little like an option that is gone.
  const std::string nearest = nearestName(name, names);
  const bool near = !nearest.empty() && editDistance(lowerCase(name), lowerCase(nearest)) <=
                                            std::max<size_t>(2, name.size() / 4);
  return near ? fmt::format("did you mean {}?", nearest) : "";
}

OptionSet discoverOptions(const std::map<std::string, FileLines>& files, Diagnostics& diagnostics) {
  const auto references = findReferences(files);
  OptionSet options;
  Merger merger(options.all(), diagnostics);
  OptionLimit limit(diagnostics);
  std::vector<std::string> paths;
  for (const auto& entry : files) paths.push_back(entry.first);
  for (const std::string& file : inJavaHashOrder(std::move(paths))) {
    const FileLines& lines = files.at(file);
    for (size_t i = 0; i < lines.size(); ++i) {
      const auto option = parseOptionLine(lines[i]);
      if (option && (!option->isBoolean || references.names.contains(option->name))) {
        if (limit.fits(*option, place(file, i, lines[i])))
          merger.add(*option, place(file, i, lines[i]), lines[i]);
      } else if (const std::string_view name = definedName(lines[i]); !name.empty()) {
        reject(options, name, place(file, i, lines[i]),
               reasonAgainst(lines[i], name, option.has_value(), references));
      }
    }
    merger.endFile();
  }
  merger.finish(options.rejected());
  return options;
}

void addModFiles(const std::map<std::string, FileLines>& files, OptionSet& options) {
  for (const auto& [file, lines] : files) {
    for (size_t i = 0; i < lines.size(); ++i) {
      const auto line = parseOptionLine(lines[i]);
      const SourceLocation at = place(file, i, lines[i]);
      const auto known = line ? options.all().find(line->name) : options.all().end();
      if (known != options.all().end()) {
        if (known->second.isBoolean == line->isBoolean) known->second.at.push_back(at);
      } else if (line) {
        options.rejected().try_emplace(
            line->name,
            RejectedOption{at,
                           "only programs of other mods read that file, which Iris does not "
                           "search for options"});
      }
    }
  }
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
