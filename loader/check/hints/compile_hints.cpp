#include <orris/check/hints/compile_hints.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include <orris/check/hints/glsl_functions.h>
#include <orris/check/hints/include_hints.h>
#include <orris/check/interface/known_names.h>
#include <orris/check/interface/stage_interface.h>
#include <orris/check/interface/unused_declarations.h>
#include <orris/check/pack/pack_texts.h>
#include <orris/glsl/tokens/outline.h>
#include <orris/pack/files/text.h>

namespace orris {
namespace {

// One missing #include leaves many names unknown: a few tell it all.
constexpr std::size_t kMostExplained = 8;

std::string declarationOf(std::string_view name) {
  if (const KnownName* uniform = findKnownName(NameKind::Uniform, name);
      uniform && !uniform->type.empty())
    return fmt::format("uniform {} {};", uniform->type, name);
  return "";
}

bool isCall(const Diagnostic& error) {
  return error.message.find("no matching overloaded function") != std::string::npos;
}

class StageHints {
 public:
  StageHints(DefinitionIndex& index, const std::vector<const StageText*>& stages,
             const StageText& stage, Diagnostics& found)
      : index_(index),
        stages_(stages),
        stage_(stage),
        found_(found),
        includes_(index, stage, found) {}

  IncludeHints& includes() { return includes_; }

  void explain(std::size_t index) {
    const std::string name = unknownName(found_[index].message);
    if (!name.empty()) {
      explainName(index, name);
    } else if (found_[index].message.find("syntax error") != std::string::npos) {
      includes_.explainSyntax(index);
    } else if (found_[index].message.find("Missing entry point") != std::string::npos) {
      includes_.explainEntry(index);
    }
  }

 private:
  void explainName(std::size_t index, const std::string& name) {
    const bool call = isCall(found_[index]);
    if (call ? explainParameters(index, name) : explainVarying(index, name)) return;
    if (explainMisspelling(index, name)) return;
    if (const std::string declaration = declarationOf(name); !declaration.empty()) {
      found_[index].hint = "it must be declared: " + declaration;
    }
    includes_.explainName(index, name);
    if (found_[index].hint.empty()) call ? suggestFunction(index, name) : suggestKnown(index, name);
  }

  /// The stage before hands the name over, or the one behind reads it.
  bool explainVarying(std::size_t index, const std::string& name) {
    if (!found_[index].hint.empty() || declaresNearly(name)) return false;
    using Storage = StageGlobal::Storage;
    for (const StageText* other : stages_) {
      if (other == &stage_) continue;
      const bool before = other->stage < stage_.stage;
      for (const StageGlobal& global : readStageInterface(*other).globals) {
        const bool meets = global.storage == (before ? Storage::Out : Storage::In) &&
                           !global.block && global.name == name && global.arraySizes.empty();
        if (!meets) continue;
        const char* does = before ? "writes" : "reads";
        found_[index].hint =
            fmt::format("declare it: {} {} {};", before ? "in" : "out", global.type, name);
        found_[index].related.push_back(
            {other->text.locate(global.place.line, global.place.column),
             fmt::format("the {} stage {} it", stageName(other->stage), does)});
        return true;
      }
    }
    return false;
  }

  /// Is there a varying of this stage that it does not use, a slip away from the name?
  bool declaresNearly(const std::string& name) {
    std::vector<std::string> unused;
    for (const StageGlobal& global : readStageInterface(stage_).globals) {
      const bool varying =
          global.storage == StageGlobal::Storage::In || global.storage == StageGlobal::Storage::Out;
      if (varying && unusedDeclarations().contains(global.name)) unused.emplace_back(global.name);
    }
    return !likelyMeant(name, unused).empty();
  }

  /// The function exists with other parameters.
  bool explainParameters(std::size_t index, const std::string& name) {
    if (!functions_) functions_ = definedFunctions(stage_.text);
    const auto same = functions_->find(name);
    if (same != functions_->end()) {
      found_[index].related.push_back({same->second, "defined here with other parameters"});
      return true;
    }
    const std::vector<std::string>& builtIn = builtInFunctions();
    const bool exists = std::ranges::find(builtIn, name) != builtIn.end();
    // What a version lacks has been said.
    if (exists && found_[index].hint.empty())
      found_[index].hint = "the function exists, but takes other arguments";
    return exists;
  }

  /// "float shade(" at the start of a line: functions that nothing calls are not in the text.
  void addWrittenFunctions() {
    for (const std::string& file : includes_.files()) {
      const auto lines = index_.files().find(file);
      if (lines == index_.files().end()) continue;
      for (std::size_t i = 0; i < lines->second.size(); ++i) {
        const std::string_view line = lines->second[i];
        const std::string_view type = leadingWord(trim(line));
        const std::string_view rest = trim(trim(line).substr(type.size()));
        const std::string_view name = leadingWord(rest);
        if (type.empty() || name.empty() || type == "return" || type == "else" || name == "main" ||
            !trim(rest.substr(name.size())).starts_with('('))
          continue;
        functions_->try_emplace(
            std::string(name),
            SourceLocation{file, int(i) + 1, int(name.data() - line.data()) + 1});
      }
    }
  }

  void suggestFunction(std::size_t index, const std::string& name) {
    addWrittenFunctions();
    std::vector<std::string> names = builtInFunctions();
    for (const auto& [function, place] : *functions_) names.push_back(function);
    // Two slips in a short name make another one.
    constexpr std::size_t kShort = 6;
    const std::string meant = likelyMeant(name, names);
    if (meant.empty() || (name.size() < kShort && editDistance(name, meant) > 1)) return;
    found_[index].hint = fmt::format("did you mean {}?", meant);
    if (const auto place = functions_->find(meant); place != functions_->end())
      found_[index].related.push_back({place->second, fmt::format("{} is defined here", meant)});
  }

  // A declaration that nothing uses, a slip away from the name that nothing declares.
  bool explainMisspelling(std::size_t index, const std::string& name) {
    std::vector<std::string> unused;
    for (const auto& [word, place] : unusedDeclarations()) {
      if (word != name) unused.emplace_back(word);
    }
    const std::string meant = likelyMeant(name, unused);
    if (meant.empty()) return false;
    const TextPlace place = unusedDeclarations().at(meant);
    const SourceLocation at = stage_.text.locate(place.line, place.column);
    if (at.file.empty()) return false;
    found_[index].hint =
        fmt::format("did you mean {}, declared at {}:{}?", meant, at.file, at.line);
    if (usesOf(name) < 2) {
      found_[index].related.push_back({at, fmt::format("nothing uses '{}'", meant)});
      return true;
    }
    // One name against several: the slip is in the declaration.
    std::string line = sourceLineOf(index_, at);
    const std::size_t column = std::size_t(std::max(at.column - 1, 0));
    std::optional<LineEdit> repair;
    if (line.compare(std::min(column, line.size()), meant.size(), meant) == 0)
      repair = LineEdit{at.file, at.line, line.replace(column, meant.size(), name), true};
    add({.severity = Severity::Error,
         .id = "name-misspelt",
         .at = at,
         .message =
             fmt::format("nothing uses '{}', and '{}' is used without being declared", meant, name),
         .includedFrom = stage_.text.includedFrom(place.line, place.column),
         .sourceLine = sourceLineOf(index_, at),
         .repair = std::move(repair)});
    return true;
  }

  /// How often the text has the name: compilers end at the first that is not declared.
  int usesOf(const std::string& name) const {
    int uses = 0;
    forEachWord(stage_.text.text, [&](std::string_view word) { uses += word == name ? 1 : 0; });
    return uses;
  }

  /// Names, local ones too, that stand once in the text: in their declarations.
  const std::map<std::string_view, TextPlace>& unusedDeclarations() {
    if (!unused_) unused_ = readUnusedDeclarations(stage_.text.text);
    return *unused_;
  }

  void suggestKnown(std::size_t index, const std::string& name) {
    std::vector<std::string> names;
    for (const StageGlobal& global : readStageInterface(stage_).globals) {
      if (!global.name.empty()) names.emplace_back(global.name);
    }
    const std::string declared = likelyMeant(name, names);
    if (!declared.empty()) {
      found_[index].hint = fmt::format("did you mean {}?", declared);
      return;
    }
    const std::string known = likelyMeant(name, knownNames(NameKind::Uniform));
    const std::string declaration = known.empty() ? "" : declarationOf(known);
    if (declaration.empty()) return;
    found_[index].hint =
        fmt::format("did you mean {}? It must be declared: {}", known, declaration);
  }

  void add(Diagnostic diagnostic) { addNewPlace(std::move(diagnostic), found_); }

  DefinitionIndex& index_;
  const std::vector<const StageText*>& stages_;  ///< of the program
  const StageText& stage_;
  Diagnostics& found_;
  IncludeHints includes_;
  std::optional<std::map<std::string_view, TextPlace>> unused_;
  std::optional<std::map<std::string, SourceLocation>> functions_;  ///< that the text defines
};

}  // namespace

std::string unknownName(const std::string& message) {
  const bool undeclared = message.find("undeclared identifier") != std::string::npos ||
                          message.find("no matching overloaded function") != std::string::npos;
  if (!undeclared || message.empty() || message[0] != '\'') return "";
  const std::size_t end = message.find('\'', 1);
  return end == std::string::npos ? "" : message.substr(1, end - 1);
}

void explainUnknownNames(DefinitionIndex& index, const std::vector<const StageText*>& stages,
                         const IncludeTrial& trial, Diagnostics& found) {
  const std::size_t count = found.size();
  for (const StageText* stage : stages) {
    StageHints hints(index, stages, *stage, found);
    std::size_t explained = 0;
    for (std::size_t i = 0; i < count && explained < kMostExplained; ++i) {
      if (found[i].severity != Severity::Error || !hints.includes().covers(found[i])) continue;
      // What another version or profile of GLSL has, no declaration is missing for.
      if (!found[i].hint.empty() && !unknownName(found[i].message).empty()) continue;
      hints.explain(i);
      ++explained;
    }
    hints.includes().locate(trial);
  }
}

}  // namespace orris
