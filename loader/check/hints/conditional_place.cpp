#include <orris/check/hints/conditional_place.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include <orris/check/hints/line_trial.h>
#include <orris/glsl/syntax/conditional_balance.h>
#include <orris/glsl/tokens/source_map.h>

namespace orris {
namespace {

constexpr const char* kUnbalancedBlock = "conditional-unbalanced";
// Each trial compiles this many programs of each folder; the rest are taken to be like them.
constexpr std::size_t kMostOfFolder = 2;
constexpr std::size_t kMostConditions = 5;
// Of a file: the likeliest places come first, and where these fail the file has more than one mistake.
constexpr std::size_t kMostPlaceTrials = 200;

struct User {
  const ShaderPack* folder = nullptr;
  ProgramUnit unit;
};

/// A file whose conditionals do not pair.
struct Unbalanced {
  std::string file;
  UnbalancedConditional what;
  std::vector<User> samples;  ///< that are compiled with it, of as many folders as possible
};

/// The files with a report that a unit reads.
class Collector {
 public:
  explicit Collector(const std::vector<Diagnostics>& found) {
    for (const Diagnostics& diagnostics : found) {
      for (const Diagnostic& diagnostic : diagnostics) {
        if (diagnostic.id == kUnbalancedBlock) reported_.insert(diagnostic.at.file);
      }
    }
  }

  bool none() const { return reported_.empty(); }

  /// The files, each with at most `most` more samples.
  void add(const ShaderPack& folder, std::size_t most) {
    std::map<std::string, std::size_t> taken;
    for (const ProgramUnit& unit : programUnits(folder)) {
      const FolderBuild* build = buildOf(folder, *unit.program);
      if (!build) continue;
      for (const StageText* stage : unit.stages) {
        for (auto& [file, what] : unbalancedIn(*build, *stage)) {
          auto& samples =
              files_.try_emplace(file, Unbalanced{file, what, {}}).first->second.samples;
          const bool known = !samples.empty() && samples.back().unit.hash == unit.hash;
          if (!known && taken[file]++ < most) samples.push_back({&folder, unit});
        }
      }
    }
  }

  std::vector<Unbalanced> files() const {
    std::vector<Unbalanced> files;
    for (const auto& [name, file] : files_) files.push_back(file);
    return files;
  }

 private:
  std::map<std::string, UnbalancedConditional> unbalancedIn(const FolderBuild& build,
                                                            const StageText& stage) const {
    std::map<std::string, UnbalancedConditional> result;
    if (stage.text.sites.empty()) return result;
    Diagnostics ignored;  // reported when the program was made
    const FileLookup lookup = [&](const std::string& file) { return build.lines(file); };
    const FlatSource source =
        flatten(build.files().graph, lookup, stage.text.sites.front().file, ignored);
    for (UnbalancedConditional& what : findUnbalancedConditionals(source)) {
      const std::string& file = source.sites[std::size_t(what.at.site)].file;
      if (!what.repairs.empty() && reported_.contains(file))
        result.try_emplace(file, std::move(what));
    }
    return result;
  }

  std::set<std::string> reported_;
  std::map<std::string, Unbalanced> files_;
};

int countProblems(const Diagnostics& diagnostics) {
  return int(std::ranges::count_if(diagnostics, [](const Diagnostic& d) {
    return d.severity == Severity::Error || d.id == kUnbalancedBlock;
  }));
}

class PlaceSearch {
 public:
  PlaceSearch(const Unbalanced& unbalanced, TrialMemo& trials)
      : unbalanced_(unbalanced), trials_(trials) {
    std::string inNoOther;
    for (const std::string& stage : unbalanced.what.stages) {
      if (conditions_.size() < kMostConditions) conditions_.push_back("#ifdef " + stage);
      inNoOther += (inNoOther.empty() ? "#if !defined " : " && !defined ") + stage;
    }
    if (!inNoOther.empty()) conditions_.push_back(inNoOther);
  }

  /// What to report with the place that was tried; nullopt: no program could be made.
  std::optional<Diagnostic> run() {
    const auto& repairs = unbalanced_.what.repairs;
    for (std::size_t i = 0; i < repairs.size() && least_ > 0 && made_ < kMostPlaceTrials; ++i) {
      for (const LineEdit& edit : editsOf(repairs[i])) {
        const int left = problemsWith({edit.file, edit.line, "", edit.text});
        if (left < least_) least_ = left, best_ = i, bestEdit_ = edit;
      }
    }
    if (least_ == kUnknown) return std::nullopt;
    UnbalancedConditional settled = unbalanced_.what;
    settled.at = repairs[best_].partner;
    settled.place = repairs[best_].place;
    settled.directive = repairs[best_].directive;
    Diagnostic d = describeUnbalanced(settled, unbalanced_.file);
    d.repair = bestEdit_;
    return d;
  }

 private:
  static constexpr int kUnknown = 1 << 30;

  std::vector<LineEdit> editsOf(const ConditionalRepair& repair) const {
    if (unbalanced_.what.kind == UnbalancedConditional::Kind::Unclosed)
      return {{unbalanced_.file, repair.place.line + 1, "#endif"}};
    // What the condition was is not known: always, never, in one stage or in that which has none.
    std::vector<LineEdit> edits;
    for (const std::string& condition : conditions_)
      edits.push_back({unbalanced_.file, repair.place.line, condition});
    return edits;
  }

  /// Left in all samples, at most one more than is known to be possible.
  int problemsWith(const AddedLine& added) {
    int problems = 0;
    for (const User& sample : unbalanced_.samples) {
      problems += problemsOf(sample, added);
      if (problems > least_) break;
    }
    return problems;
  }

  int problemsOf(const User& sample, const AddedLine& added) {
    const auto trial = trialHash(*sample.folder, sample.unit, added);
    if (const auto known = trial ? trials_.find(*trial) : std::nullopt) return *known;
    ++made_;
    const auto left = diagnosticsWith(*sample.folder, sample.unit, added, CompileErrors::First);
    const int problems = countProblems(left ? *left : sample.unit.program->diagnostics);
    if (trial && left) trials_.add(*trial, problems);
    return problems;
  }

  const Unbalanced& unbalanced_;
  TrialMemo& trials_;
  std::vector<std::string> conditions_ = {"#if 1", "#if 0"};
  std::size_t best_ = 0;
  LineEdit bestEdit_;
  int least_ = kUnknown;
  std::size_t made_ = 0;  ///< trials that were not known
};

/// Replaces what was reported of the file's place.
void replaceReport(const Unbalanced& unbalanced, const Diagnostic& settled, Diagnostics& found) {
  const Diagnostic guess = describeUnbalanced(unbalanced.what, unbalanced.file);
  for (Diagnostic& d : found) {
    if (d.id != kUnbalancedBlock || d.at != guess.at || d.message != guess.message) continue;
    Diagnostic better = settled;
    better.hint = d.hint;
    better.includedFrom = d.includedFrom;
    d = std::move(better);
  }
}

}  // namespace

void settleConditionals(const std::vector<ShaderPack>& folders, int jobs,
                        TrialMemo& trials, std::vector<Diagnostics>& found) {
  Collector collector(found);
  if (collector.none()) return;
  for (const ShaderPack& folder : folders) collector.add(folder, kMostOfFolder);
  const std::vector<Unbalanced> files = collector.files();
  std::vector<Diagnostics> settled(files.size());
  const auto work = [&](std::size_t i) {
    auto tried = PlaceSearch(files[i], trials).run();
    if (!tried) return trials.encode({});
    const ShaderPack& folder = *files[i].samples.front().folder;
    tried->sourceLine = folder.sourceLine(tried->at.file, tried->at.line);
    return trials.encode({*tried});
  };
  runIsolated({.count = files.size(), .workers = jobs, .work = work},
              [&](std::size_t i, const JobOutcome& outcome) {
                if (outcome.kind == JobOutcome::Kind::Done)
                  settled[i] = trials.decode(outcome.result);
                return true;
              });
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (settled[i].empty()) continue;
    for (Diagnostics& diagnostics : found) replaceReport(files[i], settled[i].front(), diagnostics);
  }
}

}  // namespace orris
