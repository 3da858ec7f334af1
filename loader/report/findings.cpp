#include <orris/report/findings.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <tuple>

#include <orris/core/limits.h>
#include <orris/core/message_limits.h>
#include <orris/core/files/text_file.h>
#include <orris/pack/files/text.h>
#include <orris/report/ignore_comments.h>
#include <orris/report/text_style.h>

namespace orris {
namespace {

constexpr std::array<std::string_view, 6> kStageEndings = {".vsh", ".tcs", ".tes",
                                                           ".gsh", ".fsh", ".csh"};

/// "/world0/composite.fsh" -> "/world0/composite"; "" for a file that is no stage.
std::string programOf(std::string_view file) {
  for (const std::string_view ending : kStageEndings) {
    if (file.ends_with(ending)) return std::string(file.substr(0, file.size() - ending.size()));
  }
  return "";
}

/// Lines of the pack's files, each file read once.
class SourceText {
 public:
  explicit SourceText(const FileSource* files) : files_(files) {}

  std::string line(const SourceLocation& at) {
    if (files_ == nullptr || at.line <= 0) return "";
    const auto [place, isNew] = lines_.try_emplace(at.file);
    if (isNew) {
      if (const auto text = readText(*files_, at.file)) place->second = splitLines(*text);
    }
    const auto index = static_cast<std::size_t>(at.line - 1);
    return index < place->second.size() ? place->second[index] : "";
  }

 private:
  const FileSource* files_;
  std::map<std::string, std::vector<std::string>> lines_;
};

class Judge {
 public:
  Judge(const PackResult& pack, const JudgeOptions& options, Baseline* baseline)
      : files_(pack.verdict.files.get()),
        root_(pack.root),
        options_(options),
        baseline_(baseline),
        text_(files_) {
    if (files_ != nullptr) comments_.emplace(*files_);
    programs_ = pack.verdict.programs.all;
    for (const auto& [mod, programs] : pack.verdict.modPrograms)
      programs_.insert(programs.all.begin(), programs.all.end());
  }

  /// `cause`: the number of an earlier or later call whose problem this one follows from.
  void add(Diagnostic diagnostic, const std::set<std::string>& entryFiles,
           std::optional<std::size_t> cause = std::nullopt) {
    causes_.push_back(cause);
    Finding finding{.diagnostic = std::move(diagnostic)};
    Diagnostic& d = finding.diagnostic;
    if (d.sourceLine.empty()) d.sourceLine = quoteLine(d.at);
    finding.uri = uriOf(d.at.file);
    for (const std::string& file : entryFiles) {
      const std::string program = programOf(file);
      // Files of other folders may be named like stages. Compute shaders are listed by file. A check of some
      // programs lists none.
      const bool listed = programs_.contains(program) || programs_.contains(file);
      if (programs_.empty() ? !program.empty() : listed) finding.programs.insert(program);
    }
    if (comments_ && comments_->silences(d)) finding.silence = Silence::Comment;
    applySeverity(finding);
    finding.fingerprint = fingerprintOf(d);
    findings_.push_back(std::move(finding));
  }

  std::vector<Finding> finish() {
    if (comments_) {
      for (Diagnostic& problem : comments_->problems()) add(std::move(problem), {});
    }
    for (Finding& finding : findings_) {
      const bool open =
          finding.silence == Silence::None && finding.diagnostic.severity != Severity::Note;
      if (open && baseline_ != nullptr && baseline_->take(finding.fingerprint)) {
        finding.silence = Silence::Baseline;
      }
    }
    return sorted(folded());
  }

 private:
  std::string quoteLine(const SourceLocation& at) {
    if (quotedBytes_ > limits::kMessageListBytes) return "";
    std::string line = quotedLine(text_.line(at), at.column);
    quotedBytes_ += line.size();
    return line;
  }

  static std::vector<Finding> sorted(std::vector<Finding> findings) {
    const auto order = [](const Finding& finding) {
      const Diagnostic& d = finding.diagnostic;
      return std::tuple<bool, int, const std::string&, int, int>(
          finding.follows.empty() && !(d.repair && d.severity == Severity::Error),
          -int(d.severity), d.at.file, d.at.line, d.at.column);
    };
    std::ranges::stable_sort(findings, {}, order);
    for (Finding& finding : findings) finding.follows = sorted(std::move(finding.follows));
    return findings;
  }

  /// What is silenced stands alone, and so does what follows from it: nobody would see it otherwise.
  std::vector<Finding> folded() {
    const auto isOpen = [&](std::size_t i) { return findings_[i].silence == Silence::None; };
    std::vector<Finding> top;
    for (std::size_t i = 0; i < findings_.size(); ++i) {
      const auto cause = causes_[i];
      if (!cause || !isOpen(i) || !isOpen(*cause)) continue;
      Finding& main = findings_[*cause];
      // The programs fail by the cause.
      main.programs.insert(findings_[i].programs.begin(), findings_[i].programs.end());
      main.follows.push_back(findings_[i]);
    }
    for (std::size_t i = 0; i < findings_.size(); ++i) {
      const auto cause = causes_[i];
      if (!cause || !isOpen(i) || !isOpen(*cause)) top.push_back(std::move(findings_[i]));
    }
    return top;
  }

  void applySeverity(Finding& finding) const {
    const auto chosen = options_.severities.find(finding.diagnostic.id);
    if (chosen == options_.severities.end()) return;
    finding.milder = finding.silence == Silence::None &&
                     (!chosen->second || *chosen->second < finding.diagnostic.severity);
    if (chosen->second)
      finding.diagnostic.severity = *chosen->second;
    else if (finding.silence == Silence::None)
      finding.silence = Silence::Flag;
  }

  // A problem of a program as a whole names the program: its first stage stands for it.
  std::string uriOf(const std::string& file) const {
    if (!file.starts_with('/') || files_ == nullptr) return file;
    if (file == "/") return root_;
    for (const std::string_view ending : kStageEndings) {
      const std::string stage = file + std::string(ending);
      if (files_->contains(stage)) return root_ + stage;
    }
    return root_ + file;
  }

  const FileSource* files_;
  const std::string& root_;
  const JudgeOptions& options_;
  Baseline* baseline_;
  SourceText text_;
  std::set<std::string> programs_;  ///< of the pack, as PackVerdict has them
  std::optional<IgnoreComments> comments_;
  std::vector<Finding> findings_;
  std::size_t quotedBytes_ = 0;
  std::vector<std::optional<std::size_t>> causes_;  ///< of each
};

}  // namespace

PackResult judgePack(PackVerdict verdict, const ProblemList& problems, const JudgeOptions& options,
                     Baseline* baseline) {
  PackResult result;
  result.root = options.sourceRoot.value_or(shadersFolderOf(verdict.path));
  result.verdict = std::move(verdict);
  Judge judge(result, options, baseline);
  for (std::size_t i = 0; i < problems.all().size(); ++i) {
    judge.add(problems.all()[i], problems.entryFiles(i), problems.cause(i));
  }
  result.findings = judge.finish();
  const bool failed = std::ranges::any_of(result.findings, [&](const Finding& finding) {
    return countsAsFailure(finding, options.strict);
  });
  if (failed) result.verdict.status = std::max<int>(result.verdict.status, kProblems);
  return result;
}

void addPack(ValidateResult& result, PackVerdict verdict, const ProblemList& problems,
             const JudgeOptions& options) {
  Baseline* baseline = result.baseline ? &*result.baseline : nullptr;
  result.packs.push_back(judgePack(std::move(verdict), problems, options, baseline));
  result.status = std::max(result.status, result.packs.back().verdict.status);
}

bool countsAsFailure(const Finding& finding, bool strict) {
  const auto fails = [&](const Finding& other) { return countsAsFailure(other, strict); };
  if (std::ranges::any_of(finding.follows, fails)) return true;
  return finding.silence == Silence::None &&
         finding.diagnostic.severity >= (strict ? Severity::Warning : Severity::Error);
}

// Notes are not printed as a rule, so they need not be known either.
std::string baselineOf(const ValidateResult& result) {
  Diagnostics problems;
  for (const PackResult& pack : result.packs) {
    for (const Finding& finding : pack.findings) {
      const bool known = finding.silence == Silence::None || finding.silence == Silence::Baseline;
      if (known && finding.diagnostic.severity != Severity::Note) {
        problems.push_back(finding.diagnostic);
      }
      for (const Finding& other : finding.follows) {
        if (other.diagnostic.severity != Severity::Note) problems.push_back(other.diagnostic);
      }
    }
  }
  return formatBaseline(problems);
}

}  // namespace orris
