#include <orris/check/compile/unused_functions.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include <orris/check/compile/program_check.h>
#include <orris/check/workers/diagnostic_codec.h>
#include <orris/check/workers/isolated_jobs.h>
#include <orris/glsl/compile/validate.h>
#include <orris/glsl/syntax/function_syntax.h>

namespace orris {
namespace {

/// A function is known by the place where it begins.
using FunctionPlace = std::pair<std::string, int>;

struct TextPosition {
  int line = 1, column = 1;
};

TextPosition positionAt(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, offset);
  const std::size_t start = before.rfind('\n') + 1;  // npos + 1 is 0
  return {static_cast<int>(std::count(before.begin(), before.end(), '\n')) + 1,
          static_cast<int>(offset - start) + 1};
}

/// One function that a stage leaves out.
struct LeftOut {
  FunctionPlace place;
  std::size_t offset = 0;  ///< in the text of the stage
  std::string_view source;
};

/// Ends of the functions in a text that holds nothing else.
std::vector<std::size_t> functionEnds(std::string_view source) {
  std::vector<std::size_t> ends;
  int depth = 0;
  for (std::size_t i = 0; i < source.size(); ++i) {
    if (source[i] == '{') ++depth;
    if (source[i] == '}' && --depth == 0) ends.push_back(i + 1);
  }
  return ends;
}

std::vector<LeftOut> leftOutOf(const StageText& stage) {
  std::vector<LeftOut> functions;
  const std::string_view text = stage.text.text;
  std::size_t scanned = 0, lineStart = 0;
  int line = 1;
  for (const MappedText::Unused& unused : stage.text.unused) {
    std::size_t begin = 0;
    for (const std::size_t end : functionEnds(unused.source)) {
      begin = unused.source.find_first_not_of(" \n", begin);
      for (; scanned < unused.offset + begin; ++scanned) {
        if (text[scanned] != '\n') continue;
        ++line;
        lineStart = scanned + 1;
      }
      const SourceLocation at = stage.text.locate(line, static_cast<int>(scanned - lineStart) + 1);
      const std::string_view source = std::string_view(unused.source).substr(begin, end - begin);
      functions.push_back({{at.file, at.line}, scanned, source});
      begin = end;
    }
  }
  return functions;
}

/// A stage, once for each text, and what it leaves out.
struct StageFunctions {
  const StageText* stage = nullptr;
  std::vector<LeftOut> functions;
  bool compiles = true;  ///< without them
};

class UnusedFunctions {
 public:
  UnusedFunctions(std::span<const ShaderPack> folders, const Verdicts& verdicts)
      : folders_(folders) {
    std::set<std::string_view> seen;
    for (const ShaderPack& folder : folders) {
      for (const ProgramUnit& unit : programUnits(folder)) {
        if (!unit.mod.empty() || unit.incomplete) continue;
        for (const StageText* stage : unit.judged) {
          const auto verdict = verdicts.find(unit.hash);
          const bool compiles = verdict == verdicts.end() || verdict->second;
          if (seen.insert(stage->text.text).second) add(*stage, compiles);
        }
      }
    }
    for (const StageFunctions& candidate : candidates_) dropCalled(candidate);
  }

  Diagnostics run() {
    std::stable_sort(candidates_.begin(), candidates_.end(), [](const auto& a, const auto& b) {
      return a.functions.size() > b.functions.size();
    });
    for (const StageFunctions& candidate : candidates_) judge(candidate);
    Diagnostics found;
    for (const auto& [place, errors] : failed_) {
      if (!fine_.contains(place)) found.push_back(errors.front());
    }
    return found;
  }

 private:
  // More programs would hardly say anything else.
  static constexpr std::size_t kMostTried = 3;

  void add(const StageText& stage, bool compiles) {
    candidates_.push_back({&stage, leftOutOf(stage), compiles});
    for (const LeftOut& function : candidates_.back().functions)
      open_[function.place.first].insert(function.place.second);
  }

  /// A function that stands in the text of another program is one of a library, made for that one.
  void dropCalled(const StageFunctions& candidate) {
    const MappedText& text = candidate.stage->text;
    std::set<FunctionPlace> leftOut;
    for (const LeftOut& function : candidate.functions) leftOut.insert(function.place);
    std::vector<std::set<int>*> openOfSite;
    for (const IncludeSite& site : text.sites) {
      const auto known = open_.find(site.file);
      openOfSite.push_back(known == open_.end() ? nullptr : &known->second);
    }
    for (const auto& line : text.lines) {
      for (const auto& [column, origin, macro, written] : line) {
        if (origin.site < 0) continue;
        const auto site = static_cast<std::size_t>(origin.site);
        std::set<int>* open = openOfSite[site];
        if (open && open->contains(origin.line) &&
            !leftOut.contains({text.sites[site].file, origin.line}))
          open->erase(origin.line);
      }
    }
  }

  bool isOpen(const LeftOut& function) const {
    const auto lines = open_.find(function.place.first);
    if (lines == open_.end() || !lines->second.contains(function.place.second)) return false;
    const auto failed = failed_.find(function.place);
    return !fine_.contains(function.place) &&
           (failed == failed_.end() || failed->second.size() < kMostTried);
  }

  /// Compiles the stage with its functions, without each that fails.
  void judge(const StageFunctions& candidate) {
    if (!candidate.compiles) return;
    std::vector<const LeftOut*> inside;
    for (const LeftOut& function : candidate.functions) {
      if (isOpen(function)) inside.push_back(&function);
    }
    while (!inside.empty()) {
      const auto error = firstError(*candidate.stage, inside);
      if (!error) {
        for (const LeftOut* function : inside) fine_.insert(function->place);
        return;
      }
      const auto holds = [&](const LeftOut* function) { return isIn(*error, *function); };
      const auto guilty = std::find_if(inside.begin(), inside.end(), holds);
      if (guilty == inside.end()) return;  // the program itself is wrong, which is reported
      note(**guilty, *error);
      inside.erase(guilty);
    }
  }

  std::optional<Diagnostic> firstError(const StageText& stage,
                                       const std::vector<const LeftOut*>& inside) const {
    StageText whole = stage;
    for (const LeftOut* function : inside)
      whole.text.text.replace(function->offset, function->source.size(), function->source);
    Diagnostics found;
    validateWithGlslang(
        {&whole},
        [this](const std::string& file, int line) {
          return folders_.front().sourceLine(file, line);
        },
        found, CompileErrors::First);
    const auto error = std::find_if(found.begin(), found.end(), [](const Diagnostic& d) {
      return d.severity == Severity::Error;
    });
    return error == found.end() ? std::nullopt : std::optional(std::move(*error));
  }

  static bool isIn(const Diagnostic& error, const LeftOut& function) {
    const auto breaks = std::count(function.source.begin(), function.source.end(), '\n');
    const int last = function.place.second + static_cast<int>(breaks);
    return error.at.file == function.place.first && error.at.line >= function.place.second &&
           error.at.line <= last;
  }

  void note(const LeftOut& function, Diagnostic error) {
    // Iris refuses the program for it: checkUnusedSyntax() reports that.
    if (findSyntaxMistake(function.source)) return void(fine_.insert(function.place));
    error.severity = Severity::Warning;
    error.id = "unused-function-broken";
    error.message =
        "not called, so that Iris leaves the function out; it would not compile: " + error.message;
    failed_[function.place].push_back(std::move(error));
  }

  std::span<const ShaderPack> folders_;
  std::vector<StageFunctions> candidates_;
  std::map<std::string, std::set<int>> open_;    ///< file, lines of functions that nothing calls
  std::map<FunctionPlace, Diagnostics> failed_;  ///< one error for each program tried
  std::set<FunctionPlace> fine_;
};

}  // namespace

void checkUnusedSyntax(const ShaderPack& pack, const StageText& stage, Diagnostics& diagnostics) {
  for (const MappedText::Unused& unused : stage.text.unused) {
    const auto mistake = findSyntaxMistake(unused.source);
    if (!mistake) continue;
    const auto [line, column] = positionAt(stage.text.text, unused.offset + mistake->offset);
    Diagnostic& error = diagnostics.emplace_back();
    error.id = "glsl-compile";
    error.at = stage.text.locate(line, column);
    error.message = mistake->message;
    error.includedFrom = stage.text.includedFrom(line, column);
    error.sourceLine = pack.sourceLine(error.at.file, error.at.line);
    error.notes.emplace_back(
        "nothing calls the function, but Iris reads it before it leaves it out, and refuses the "
        "program");
  }
}

void checkUnusedFunctions(std::span<const ShaderPack> folders, int jobs, const Verdicts& verdicts,
                          Diagnostics& diagnostics) {
  if (folders.empty()) return;
  // In a process of its own, as the functions may be anything.
  const auto work = [&](std::size_t) {
    return encodeDiagnostics(UnusedFunctions(folders, verdicts).run());
  };
  runIsolated({.count = 1, .workers = jobs, .work = work}, [&](std::size_t, const JobOutcome& outcome) {
    if (outcome.kind != JobOutcome::Kind::Done) return true;
    const Diagnostics found = decodeDiagnostics(outcome.result);
    diagnostics.insert(diagnostics.end(), found.begin(), found.end());
    return true;
  });
}

}  // namespace orris
