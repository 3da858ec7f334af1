#include <orris/check/options/option_checks.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include <orris/check/pack/pack_texts.h>
#include <orris/core/files/text_file.h>
#include <orris/pack/files/text.h>
#include <orris/pack/options/option_line.h>

namespace orris {
namespace {

using Site = std::pair<std::string_view, int>;

/// Reports at `word` of the line, where it occurs.
Diagnostic optionDiagnostic(AuthorLines& lines, Severity severity, std::string id,
                            SourceLocation at, const std::string& word, std::string message,
                            std::string hint = {}) {
  const std::string& line = lines.at(at);
  const size_t column = line.find(word);
  if (column != std::string::npos) at.column = static_cast<int>(column) + 1;
  return {.severity = severity,
          .id = std::move(id),
          .at = std::move(at),
          .message = std::move(message),
          .sourceLine = line,
          .hint = std::move(hint)};
}

std::vector<std::string> listOf(const std::string& line) {
  const size_t open = line.find('['), close = line.find(']', open);
  if (open == std::string::npos || close == std::string::npos) return {};
  return splitBlanks(std::string_view(line).substr(open + 1, close - open - 1));
}

/// What Iris makes of the characters between two values. Iris: StringOption.
void checkSeparators(AuthorLines& lines, const Option& option, bool shown,
                     Diagnostics& diagnostics) {
  const SourceLocation& place = option.at.front();
  const auto report = [&](const char* id, std::string message, std::string hint) {
    // Nobody meets the values of an option that no screen shows: "[0.1, 1.0]" may be a remark.
    diagnostics.push_back(optionDiagnostic(lines, shown ? Severity::Warning : Severity::Note, id,
                                           place, option.name, std::move(message),
                                           std::move(hint)));
  };
  const auto comma = std::ranges::find_if(
      option.values, [](const std::string& value) { return value.ends_with(','); });
  if (comma != option.values.end()) {
    report("option-list-commas",
           fmt::format("values of {} end with a comma, \"{}\": Iris separates them by blanks alone",
                       option.name, *comma),
           "write [1 2 3]");
  }
  if (std::ranges::find(option.values, "") != option.values.end()) {
    report("option-value-empty",
           fmt::format("two blanks side by side, or one after the bracket, give {} an empty value "
                       "that players can choose",
                       option.name),
           "write one blank between two values, and none after [");
  }
}

/// How the screens show an option.
struct Shown {
  bool at = false, slider = false;
};

/// The value that a list has twice, "" for none.
std::string repeatedValue(const std::vector<std::string>& list) {
  std::set<std::string_view> seen;
  for (const std::string& value : list) {
    if (!seen.insert(value).second) return value;
  }
  return "";
}

void checkList(AuthorLines& lines, const Option& option, Shown shown, Diagnostics& diagnostics) {
  checkSeparators(lines, option, shown.at, diagnostics);
  // Any of the lists may be the one that is shown. Iris: MergedStringOption
  for (const SourceLocation& place : option.at) {
    const std::string value = repeatedValue(listOf(lines.at(place)));
    if (value.empty()) continue;
    const bool button = shown.at && !shown.slider;
    diagnostics.push_back(optionDiagnostic(
        lines, button ? Severity::Warning : Severity::Note, "option-value-twice", place,
        option.name, fmt::format("the list of {} has {} twice", option.name, value),
        button ? "the button that steps through the values never gets past the second one" : ""));
    break;
  }
  const SourceLocation& place = option.at.front();
  const std::vector<std::string> list = listOf(lines.at(place));
  if (std::ranges::find(list, option.defaultValue) == list.end()) {
    diagnostics.push_back(
        optionDiagnostic(lines, Severity::Note, "option-default", place, option.name,
                         fmt::format("{} is {}, which its list lacks; it is added at the end",
                                     option.name, option.defaultValue)));
  }
}

/// Iris: MergedStringOption keeps the list of the first line that has a text beside it, else of the last, in
/// the order of its table of files.
std::string shownList(AuthorLines& lines, const Option& option) {
  const std::set<std::string> shown(option.values.begin(), option.values.end());
  const auto place = std::ranges::find_if(option.at, [&](const SourceLocation& at) {
    const auto list = listOf(lines.at(at));
    std::set<std::string> values(list.begin(), list.end());
    if (values.empty()) return false;
    values.insert(option.defaultValue);
    return values == shown;
  });
  return place == option.at.end() ? "Iris shows one of them"
                                  : fmt::format("Iris shows the one of {}:{}", place->file, place->line);
}

void checkSameLists(AuthorLines& lines, const Option& option, Diagnostics& diagnostics) {
  const auto setOf = [&](const SourceLocation& place) {
    const auto list = listOf(lines.at(place));
    return std::set<std::string>(list.begin(), list.end());
  };
  const SourceLocation& first = option.at.front();
  const auto other = std::find_if(option.at.begin() + 1, option.at.end(),
                                  [&](const auto& place) { return setOf(place) != setOf(first); });
  if (other == option.at.end()) return;
  diagnostics.push_back(optionDiagnostic(
      lines, Severity::Warning, "option-list-differs", *other, option.name,
      fmt::format("the list of {} differs from the one in {}:{}", option.name, first.file,
                  first.line),
      shownList(lines, option) + (other->file == first.file ? ", whatever #if stands around it" : "")));
  diagnostics.back().related.push_back({first, "the other list"});
}

/// Names that texts mention outside the lines that define them.
class Mentions {
 public:
  explicit Mentions(const OptionSet& options) : options_(options) {
    for (const auto& [name, option] : options.all()) {
      for (const SourceLocation& place : option.at) definitions_[{place.file, place.line}] = name;
    }
  }

  void addFile(const std::string& file, const FileLines& lines) {
    for (size_t i = 0; i < lines.size(); ++i) {
      if (isEmptyTest(lines, i)) continue;
      const auto defined = definitions_.find({file, static_cast<int>(i) + 1});
      const std::string_view own =
          defined == definitions_.end() ? std::string_view() : defined->second;
      forEachWord(lines[i], [&](std::string_view word) {
        if (word != own) add(word);
      });
      if (lines[i].find("##") != std::string::npos) addPieces(lines[i]);
    }
  }

  void add(std::string_view word) {
    if (options_.find(word)) names_.emplace(word);
  }

  /// A name may also be put together: A##_STEPS.
  bool contains(const std::string& name) const {
    return names_.contains(name) ||
           std::any_of(pieces_.begin(), pieces_.end(), [&](const std::string& piece) {
             return name.starts_with(piece) || name.ends_with(piece);
           });
  }

 private:
  /// "#ifdef NAME" with "#endif" below it makes NAME an option for the screens and does nothing.
  static bool isEmptyTest(const FileLines& lines, size_t index) {
    if (booleanReference(lines[index]).empty()) return false;
    for (size_t next = index + 1; next < lines.size(); ++next) {
      const std::string_view line = trim(lines[next]);
      if (!line.empty()) return line.starts_with("#endif");
    }
    return true;
  }

  void addPieces(std::string_view line) {
    constexpr size_t kShortest = 3;
    for (size_t at = line.find("##"); at != std::string_view::npos; at = line.find("##", at + 2)) {
      const std::string_view before = trim(line.substr(0, at)), after = trim(line.substr(at + 2));
      size_t begin = before.size();
      while (begin > 0 && isWordCharacter(before[begin - 1])) --begin;
      for (const std::string_view piece : {before.substr(begin), leadingWord(after)}) {
        if (piece.size() >= kShortest && pieces_.size() < kMostPieces) pieces_.emplace(piece);
      }
    }
  }

  static constexpr size_t kMostPieces = 256;

  const OptionSet& options_;
  std::set<std::string> pieces_;
  std::map<Site, std::string> definitions_;
  std::set<std::string, std::less<>> names_;
};

/// Options that exist for their text on the screen: one value, or values that number the texts.
bool isInformation(const ShaderPack& pack, const Option& option) {
  constexpr std::array<std::string_view, 6> kWords{"info",    "about",   "author",
                                                   "version", "website", "credit"};
  constexpr size_t kMostTexts = 5;
  const std::string name = lowerCase(option.name);
  const bool named = std::any_of(kWords.begin(), kWords.end(),
                                 [&](auto word) { return name.find(word) != std::string::npos; });
  // "PT0", "PT1", ...
  const size_t letters = option.values.front().find_first_of("0123456789");
  const auto numberOf = [&](const std::string& value) {
    const bool alike = value.substr(0, letters) == option.values.front().substr(0, letters);
    return alike && letters < value.size() ? parseInteger(value.substr(letters)) : std::nullopt;
  };
  const auto hasText = [&](const auto& language) {
    const auto text = language.second.lower_bound("value." + option.name + ".");
    return text != language.second.end() && text->first.starts_with("value." + option.name + ".");
  };
  const auto first = letters == std::string::npos ? std::nullopt : numberOf(option.values.front());
  bool counts = first && (option.values.size() <= kMostTexts ||
                          std::ranges::any_of(pack.languages, hasText));
  for (size_t i = 1; counts && i < option.values.size(); ++i) {
    counts = numberOf(option.values[i]) == *first + static_cast<long long>(i);
  }
  return named || counts || option.values.size() < 2;
}

void addProperties(const ShaderPack& pack, Mentions& mentions) {
  const auto add = [&](std::string_view word) { mentions.add(word); };
  for (const char* file : {"/block.properties", "/item.properties", "/entity.properties"}) {
    if (const auto text = readText(*pack.source, file)) forEachWord(*text, add);
  }
  const auto text = readText(*pack.source, "/shaders.properties");
  if (!text) return;
  for (const PropertyEntry& entry :
       parseProperties("/shaders.properties", *text, Continuation::Java)) {
    const bool shows =
        isScreenKey(entry.key) || entry.key == "sliders" || entry.key.starts_with("profile.");
    if (!shows) forEachWord(entry.key + " " + entry.value, add);
  }
  for (const std::string& line : splitLines(*text)) {
    if (trim(line).starts_with('#')) forEachWord(line, add);
  }
}

/// Programs of a mod that traces rays, which no other host reads.
void addRayPrograms(const ShaderPack& pack, Mentions& mentions) {
  constexpr std::array<std::string_view, 4> kEndings = {".rgen", ".rchit", ".rmiss", ".rahit"};
  for (const std::string& path : pack.source->files()) {
    const bool traces = std::ranges::any_of(
        kEndings, [&](std::string_view ending) { return path.ends_with(ending); });
    const auto text = traces ? readText(*pack.source, path) : std::nullopt;
    if (text) forEachWord(*text, [&](std::string_view word) { mentions.add(word); });
  }
}

}  // namespace

ShownOptions::ShownOptions(const ShaderPack& pack) {
  for (const Screen& screen : pack.properties.screens)
    names_.insert(screen.entries.begin(), screen.entries.end());
  all_ = names_.empty() || names_.contains("*");
}

void checkOptionLists(std::span<const ShaderPack> folders, Diagnostics& diagnostics) {
  const ShaderPack& pack = folders.front();
  AuthorLines lines(pack);
  const ShownOptions shown(pack);
  for (const auto& [name, option] : pack.options.all()) {
    if (option.isBoolean) continue;
    const auto& sliders = pack.properties.sliders;
    const bool slider = std::find(sliders.begin(), sliders.end(), name) != sliders.end();
    checkList(lines, option, {.at = shown.contains(name), .slider = slider}, diagnostics);
    checkSameLists(lines, option, diagnostics);
  }
}

void checkOptionUse(std::span<const ShaderPack> folders, Diagnostics& diagnostics) {
  const ShaderPack& pack = folders.front();
  Mentions mentions(pack.options);
  AuthorLines lines(pack);
  for (const auto& entry : pack.files) mentions.addFile(entry.first, lines.file(entry.first));
  addRayPrograms(pack, mentions);
  addProperties(pack, mentions);
  const ShownOptions shown(pack);
  for (const auto& [name, option] : pack.options.all()) {
    const SourceLocation& place = option.at.front();
    const auto line = parseOptionLine(lines.at(place));
    const bool directive = line && line->isConst;
    if (directive || mentions.contains(name)) continue;
    // Boolean options without effect are tested on purpose: mods look for them.
    const bool onScreen = shown.contains(name);
    const bool matters = onScreen && !option.isBoolean && !isInformation(pack, option);
    diagnostics.push_back(optionDiagnostic(
        lines, matters ? Severity::Warning : Severity::Note, "option-unused", place, name,
        fmt::format("{} changes nothing: {}no program and no condition of a properties file uses it",
                    name, onScreen ? "it is on a screen, but " : ""),
        onScreen ? "use it, or take it off the screens" : "use it, or remove it"));
  }
}

void checkHiddenOptions(std::span<const ShaderPack> folders, Diagnostics& diagnostics) {
  const ShaderPack& pack = folders.front();
  const ShownOptions shown(pack);
  if (shown.all()) return;
  AuthorLines lines(pack);
  for (const auto& [name, option] : pack.options.all()) {
    if (shown.contains(name)) continue;
    diagnostics.push_back(optionDiagnostic(lines, Severity::Note, "option-hidden",
                                           option.at.front(), name,
                                           fmt::format("no screen shows {}", name)));
  }
}

}  // namespace orris
